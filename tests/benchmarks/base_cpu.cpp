// Measures in real time what share of a core a base's driver and robot_base take: a process of their own,
// with a real driver at the pseudo-terminal of its emulator; floor, emulator and the commander of its wheels
// are another process.
//   base_cpu [--unguarded] ROBOT.yaml [SECONDS]      a robot file such as config/robots/kobuki.yaml
// --unguarded: the port has no guardian, for what one costs: its own process, and the heartbeat of this one.
// CPU time of the whole process, DDS included, and of each of its threads; other programs on the machine take
// no part in it, but caches that they wash out do. Asked: less than 2 % of a core. A measurement, not a test:
// it judges nothing; status 1 when the base did not drive all the time.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "components/robot_base/driver_registry.hpp"
#include "runtime/base/byte_link.hpp"
#include "runtime/host/host.hpp"
#include "tests/benchmarks/commanded_base.hpp"
#include "tests/faults/guardian_of.hpp"

namespace bw {
namespace {

constexpr const char* kGraph = R"(
components:
  world: {enabled: false, manager: none, process: floor, lane: world,
          emulation: {base: {enabled: true, parameters: {encoder_rate: 100}}},
          parameters: {walls: [{x1: -50, y1: 20, x2: 50, y2: 20}]}}
  base_emulator: {enabled: false, manager: none, process: floor, lane: devices, emulation: {base: {enabled: true}}}
  robot_base: {manager: none, process: base, lane: base, inputs: {wheel_commands: {external: true}}}
)";

/// [s] of each thread, by its name.
std::map<std::string, double> thread_seconds() {
  std::map<std::string, double> all;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    double nanoseconds = 0.0;
    std::ifstream(task.path() / "schedstat") >> nanoseconds;
    all[name] += 1e-9 * nanoseconds;
  }
  return all;
}

/// [s] of the guardian's process; 0 without one.
double guardian_seconds() {
  const pid_t guardian = test::guardian_of(getpid());
  double nanoseconds = 0.0;
  if (guardian > 0) std::ifstream("/proc/" + std::to_string(guardian) + "/schedstat") >> nanoseconds;
  return 1e-9 * nanoseconds;
}

/// Its cable has no guardian then. A robot has no such switch, so that the registered type itself is changed.
void take_stop_frame_from(const std::string& driver) {
  auto* type = const_cast<DriverType*>(find_driver(driver));
  type->make = [make = type->make](const AnyOptions& options, const DriverContext& context) {
    DriverContext unguarded = context;
    unguarded.open_link = [&context](const PortOptions& port, const std::vector<std::uint8_t>&) {
      return context.open_link(port, {});
    };
    return make(options, unguarded);
  };
}

/// Measures from when the base has driven for 2 s; a base that stops by itself is not what is asked for.
class Meter final : public Component {
 public:
  Meter(double seconds, bool& measured) : span_(Duration::seconds(seconds)), measured_(measured) {}
  void configure(Setup& setup) override {
    finish_ = setup.finish_run();
    setup.input<BaseState>("base_state", Qos::standard(),
                           [this](const BaseState& state, const Tick& tick) { on_state(state, tick.now); });
  }

 private:
  using BaseState = bandwagon_msgs::msg::BaseState;

  void on_state(const BaseState& state, Time now) {
    if (state.state() != bandwagon_msgs::msg::BaseState_Constants::DRIVING) {
      if (began_) finish_(false, "the base stopped: " + state.reason());
      driving_since_.reset();
      return;
    }
    if (!driving_since_) driving_since_ = now;
    if (!began_ && now - *driving_since_ >= Duration::seconds(2.0)) {
      began_ = now;
      cpu_ = cpu_seconds();
      threads_ = thread_seconds();
      guardian_ = guardian_seconds();
    } else if (began_ && !measured_ && now - *began_ >= span_) {
      report((now - *began_).to_seconds());
      measured_ = true;
      finish_(true, "");
    }
  }

  void report(double seconds) {
    const double share = 100.0 / seconds;
    std::printf("driver and base: %.2f %% of a core\n", share * (cpu_seconds() - cpu_));
    for (const auto& [name, now] : thread_seconds()) {
      const double of_thread = share * (now - threads_[name]);
      if (of_thread >= 0.01) std::printf("  %-16s %.2f %%\n", name.c_str(), of_thread);
    }
    std::printf("its guardian: %.2f %% of a core\n", share * (guardian_seconds() - guardian_));
  }

  Duration span_;
  bool& measured_;
  std::function<void(bool, const std::string&)> finish_;
  std::optional<Time> driving_since_, began_;
  double cpu_ = 0.0, guardian_ = 0.0;
  std::map<std::string, double> threads_;
};

}  // namespace
}  // namespace bw

int main(int argc, char** argv) {
  const bool is_guarded = argc < 2 || std::string(argv[1]) != "--unguarded";
  if (!is_guarded) {
    --argc;
    ++argv;
  }
  if (argc < 2) {
    std::fprintf(stderr, "usage: base_cpu [--unguarded] ROBOT.yaml [SECONDS]\n");
    return 2;
  }
  const double seconds = argc < 3 ? 60.0 : std::max(1.0, std::atof(argv[2]));
  const auto path =
      std::filesystem::temp_directory_path() / ("base_cpu_" + std::to_string(getpid()) + ".yaml");
  std::ofstream(path) << "robot: " << std::filesystem::absolute(argv[1]).string() << bw::kGraph;
  const auto graph = [&path] { return bw::load_graph(path, {"robot.laser.driver=none", "emulate=true"}); };
  const pid_t floor = fork();
  if (floor == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::vector<bw::ExtraComponent> extra;
    extra.push_back({"commander", std::make_unique<bw::Commander>(bw::WheelSpeeds{0.2, 0.25}), "commander"});
    bw::Host host(graph(), {.only_process = "floor"}, std::move(extra));
    host.run(bw::Duration::seconds(seconds + 60.0));
    return 0;
  }
  bool measured = false;
  if (!is_guarded) {
    for (const std::string& driver : bw::registered_drivers()) bw::take_stop_frame_from(driver);
  }
  {
    std::vector<bw::ExtraComponent> extra;
    extra.push_back({"meter", std::make_unique<bw::Meter>(seconds, measured), "meter"});
    bw::Host host(graph(), {.only_process = "base"}, std::move(extra));
    const bw::RunEnd end = host.run(bw::Duration::seconds(seconds + 30.0));
    if (!measured)
      std::fprintf(stderr, "nothing measured: %s\n", end.ok ? "it never drove for long" : end.reason.c_str());
  }
  kill(floor, SIGKILL);
  waitpid(floor, nullptr, 0);
  std::filesystem::remove(path);
  return measured ? 0 : 1;
}
