// Measures how soon a base without a dead-man time of its own is told to stand, and stands, when the process
// that drives it ends in any way while it drives: an emulated Kobuki on a pseudo-terminal (this program), its
// wheels at 0.5 m/s, `bandwagon run` at the other end.
//   kill_base [--limit MS] [--program PATH] KILL|STOP|ABRT|SEGV|TERM|INT|HUP|guardian TIMES
// STOP: the process hangs; it goes on after a while, and must not drive on. guardian: not the process but the
// guardian of its port is killed. Each time at another phase, and nobody may be left over. Exit status 0:
// each was told within the limit (250 ms; for TERM, INT and HUP, which end by a ramp, the limit is of nothing
// but that it stands). --program: another one than the `bandwagon` of this tree.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <sensor_msgs/msg/joint_state.hpp>

#include "components/messages/wheel_joints.hpp"
#include "runtime/host/real_time.hpp"
#include "runtime/temporary_folder.hpp"
#include "tests/faults/emulated_kobuki.hpp"
#include "tests/faults/guardian_of.hpp"
#include "tests/faults/outside_driver.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using std::chrono::milliseconds;
constexpr double kSpeed = 0.5;  // [m/s]

const std::map<std::string, int> kSignals = {{"KILL", SIGKILL}, {"STOP", SIGSTOP},    {"ABRT", SIGABRT},
                                             {"SEGV", SIGSEGV}, {"TERM", SIGTERM},    {"INT", SIGINT},
                                             {"HUP", SIGHUP},   {"guardian", SIGKILL}};

struct Figures {
  std::vector<double> stop_ms, rest_ms;
  int failed = 0;
};

class Trial {
 public:
  Trial(std::string program, const std::string& port, std::string ending)
      : program_(std::move(program)), kobuki_(port), port_(port), ending_(std::move(ending)) {}

  /// Why it failed; empty: told and at rest.
  std::string run(int phase_ms, Figures& figures) {
    Process base({program_, "run", std::string(BANDWAGON_SOURCE_DIR) + "/tests/faults/base_on_cable.yaml",
                  "--set", "robot.base.port=" + port_, "--set", "robot.laser.driver=none", "--for", "3600"});
    const auto say = [&](const std::string& what) { return what + "\n" + base.err(); };
    if (!kobuki_.live(milliseconds(20'000), [&] { return kobuki_.speed() > kSpeed - 0.01; }))
      return say("it did not drive");
    kobuki_.live(milliseconds(phase_ms), [] { return false; });
    const pid_t guardian = guardian_of(base.id());
    if (guardian < 0 && ending_ == "guardian") return say("it has no guardian");
    kobuki_.forget();
    const auto began = EmulatedKobuki::Clock::now();
    if (kill(ending_ == "guardian" ? guardian : base.id(), kSignals.at(ending_)) != 0)
      return say("no such process");
    const bool stands =
        kobuki_.live(milliseconds(5'000), [&] { return kobuki_.stop() && kobuki_.speed() < 1e-3; });
    if (!stands) return say("it drives on");
    const auto ms = [&](EmulatedKobuki::Clock::time_point at) {
      return std::chrono::duration<double, std::milli>(at - began).count();
    };
    figures.stop_ms.push_back(ms(*kobuki_.stop()));
    figures.rest_ms.push_back(ms(EmulatedKobuki::Clock::now()));
    return after(base);
  }

 private:
  std::string after(Process& base) {
    const auto drives = [&] { return kobuki_.speed() > 1e-3; };
    if (ending_ == "STOP") {
      if (kobuki_.live(milliseconds(300), drives)) return "it drove on while it was stopped";
      base.signal(SIGCONT);
      if (kobuki_.live(milliseconds(400), drives)) return "it drove on after the hang\n" + base.err();
      // Of the base's own reasons another one may come first: wheels that do not turn as they were told
      // before the hang.
      if (base.err().find("is silent, the base is told to stop") == std::string::npos)
        return "nobody says that it hung\n" + base.err();
    }
    if (ending_ == "guardian" &&
        base.err().find("the guardian of " + port_ + " is gone") == std::string::npos)
      return "it does not say that its guardian is gone\n" + base.err();
    if (ending_ == "STOP" || ending_ == "guardian") base.signal(SIGTERM);
    std::optional<int> status;
    kobuki_.live(milliseconds(10'000), [&] { return (status = base.wait(milliseconds(0))).has_value(); });
    if (!status) return "it does not end";
    const bool is_orderly = ending_ != "KILL" && ending_ != "ABRT" && ending_ != "SEGV";
    if (is_orderly && *status != 0) return "exit status " + std::to_string(*status) + "\n" + base.err();
    const pid_t parent = base.id();
    if (!kobuki_.live(milliseconds(2'000), [&] { return guardian_of(parent) < 0; }))
      return "its guardian is left over";
    return kobuki_.speed() < 1e-3 ? "" : "it drives";
  }

  std::string program_;
  EmulatedKobuki kobuki_;
  std::string port_, ending_;
};

void print(const char* what, std::vector<double> ms, double limit_ms) {
  if (ms.empty()) return;
  std::ranges::sort(ms);
  const auto in_time = std::ranges::upper_bound(ms, limit_ms) - ms.begin();
  std::printf("%s: min %.0f, median %.0f, p99 %.0f, max %.0f ms; %td of %zu within %.0f ms\n", what,
              ms.front(), ms[ms.size() / 2], ms[std::min(ms.size() - 1, ms.size() * 99 / 100)], ms.back(),
              in_time, ms.size(), limit_ms);
}

int measure(const std::string& program, const std::string& ending, int times, double limit_ms) {
  static_cast<void>(take_real_time_priority());  // what the meter itself is late would be told of the base
  const TemporaryFolder folder;
  Trial trial(program, (folder.path() / "kobuki").string(), ending);
  const WheelRadii radii{0.035, 0.035};
  const OutsideDriver<sensor_msgs::msg::JointState> commander(
      "commander", "wheel_commands", milliseconds(20), [radii] {
        return to_joint_state({kSpeed, kSpeed}, radii, system_time());
      });
  Figures figures;
  for (int i = 0; i < times; ++i) {
    // Phases of the base's 10 and 20 ms and of the guardian's, in an order without a pattern.
    const std::string failure = trial.run(100 + i * 37 % 101, figures);
    if (failure.empty()) continue;
    ++figures.failed;
    std::printf("%d: %s\n", i + 1, failure.c_str());
    std::fflush(stdout);
  }
  std::printf("%s: %d times, %d failed\n", ending.c_str(), times, figures.failed);
  print("stop frame", figures.stop_ms, limit_ms);
  print("wheels at rest", figures.rest_ms, limit_ms);
  const bool is_ramp = ending == "TERM" || ending == "INT" || ending == "HUP";
  const bool is_late =
      !is_ramp && std::ranges::any_of(figures.stop_ms, [&](double ms) { return ms > limit_ms; });
  return figures.failed == 0 && !is_late ? 0 : 1;
}

}  // namespace
}  // namespace bw::test

int main(int argc, char** argv) {
  double limit_ms = 250.0;
  std::string program = BANDWAGON_PROGRAM;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--limit" && i + 1 < argc) {
      limit_ms = std::atof(argv[++i]);
    } else if (std::string(argv[i]) == "--program" && i + 1 < argc) {
      program = argv[++i];
    } else {
      words.emplace_back(argv[i]);
    }
  }
  if (words.size() != 2 || !bw::test::kSignals.contains(words[0])) {
    std::fprintf(
        stderr,
        "usage: kill_base [--limit MS] [--program PATH] KILL|STOP|ABRT|SEGV|TERM|INT|HUP|guardian TIMES\n");
    return 2;
  }
  return bw::test::measure(program, words[0], std::max(1, std::atoi(words[1].c_str())), limit_ms);
}
