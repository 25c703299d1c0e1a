// Measures how soon the base stops when whoever commands it falls silent (SIGSTOP) or dies (SIGKILL), in real
// time: the world and the base are processes of their own, the commander a third. Two figures of each loss,
// from the last command that was sent: until the stop frame, the first slower command to the driver, and
// until the true robot has begun to decelerate.
//   lose_commander [--limit-frame MS] [--limit-motion MS] cmd_vel|wheel_commands LOSSES
// Exit status 0: all within the limits (300 and 250 ms). 300 losses take some eight minutes.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include <sensor_msgs/msg/joint_state.hpp>
#include <sys/prctl.h>
#include <unistd.h>

#include "components/messages/wheel_joints.hpp"
#include "components/model/robot.hpp"
#include "tests/faults/outside_driver.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using sensor_msgs::msg::JointState;
constexpr double kSpeed = 0.5;  // [m/s]

/// Tells, by standard output, when it is about to send.
void announce() {
  const std::string line = std::to_string(system_time().nanoseconds) + "\n";
  [[maybe_unused]] const auto written = write(STDOUT_FILENO, line.data(), line.size());
}

/// When the commander last was about to send.
Time last_announced(const std::string& said) {
  const std::size_t end = said.rfind('\n');
  if (end == std::string::npos) return {};
  const std::size_t begin = end == 0 ? std::string::npos : said.rfind('\n', end - 1);
  return {std::atoll(said.c_str() + (begin == std::string::npos ? 0 : begin + 1))};
}

/// The commander: a planner's rate, or motor_control's, until it is killed.
int command(const std::string& topic) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const WheelRadii radii = Robot().wheel_radii();
  if (topic == "cmd_vel") {
    const OutsideDriver<geometry_msgs::msg::Twist> driver("commander", topic, std::chrono::milliseconds(100),
                                                          [] {
                                                            announce();
                                                            return twist(kSpeed);
                                                          });
    for (;;) pause();
  }
  const OutsideDriver<JointState> driver("commander", topic, std::chrono::milliseconds(20), [radii] {
    announce();
    return to_joint_state({kSpeed, kSpeed}, radii, system_time());
  });
  for (;;) pause();
}

template <class M>
class Ear {
 public:
  Ear(dds::Participant& participant, const std::string& topic)
      : reader_(participant.create_reader(ros_end<M>(topic, Qos::standard(1000)), [] {})) {}
  /// The next one, and when it was sent.
  std::optional<std::pair<M, Time>> next() {
    M message;
    if (!reader_->take(sample_) || !deserialize(sample_.cdr, message)) return std::nullopt;
    return std::pair{message, sample_.sent};
  }
  void forget() {
    while (next()) {
    }
  }

 private:
  dds::Sample sample_;
  std::unique_ptr<dds::Reader> reader_;
};

struct Loss {
  double to_frame = 0.0, to_motion = 0.0;  ///< [s]
  /// It died while it sent: whether the base, which is another reader, has that command is not known.
  bool is_ambiguous = false;
};

template <class Command>
class Trial {
 public:
  explicit Trial(const std::string& topic)
      : commands_(participant_, topic),
        frames_(participant_, "sim/wheel_commands"),
        truth_(participant_, "sim/ground_truth") {}

  /// Nothing: it did not drive, or did not stop, in 20 s.
  std::optional<Loss> run(const std::string& program, const std::string& topic, int signal, int phase_ms) {
    Process commander({program, "--command", topic});
    frames_.forget();
    truth_.forget();
    double speed = 0.0;
    Time last_command{};
    const auto hear = [&] {
      while (const auto command = commands_.next()) last_command = command->second;
      while (const auto truth = truth_.next()) speed = truth->first.twist().linear().x();
    };
    const auto within = [](int seconds, const std::function<bool()>& seen) {
      return poll_until(std::chrono::steady_clock::now() + std::chrono::seconds(seconds),
                        std::chrono::milliseconds(1), seen);
    };
    const bool drives = within(20, [&] {
      hear();
      return speed > kSpeed - 1e-4 && last_command != Time{};
    });
    if (!drives) return std::nullopt;
    poll_until(std::chrono::steady_clock::now() + std::chrono::milliseconds(phase_ms),
               std::chrono::milliseconds(1), [&] {
                 hear();
                 return false;
               });
    frames_.forget();
    truth_.forget();
    commander.signal(signal);
    std::optional<Time> frame, motion;
    const bool stops = within(20, [&] {
      while (const auto command = commands_.next()) last_command = command->second;
      while (const auto wheels = frames_.next()) {
        const bool is_slower = wheels->first.velocity()[0] * Robot().wheel_radius < kSpeed - 1e-3;
        if (!frame && is_slower) frame = wheels->second;
      }
      while (const auto truth = truth_.next()) {
        speed = truth->first.twist().linear().x();
        if (!motion && speed < kSpeed - 1e-3) motion = from_stamp(truth->first.header().stamp());
      }
      return frame && motion && std::abs(speed) < 1e-6;
    });
    commander.signal(SIGKILL);
    if (!stops) return std::nullopt;
    const bool died_sending = last_announced(commander.out()) > last_command + Duration::milliseconds(10);
    return Loss{(*frame - last_command).to_seconds(), (*motion - last_command).to_seconds(), died_sending};
  }

 private:
  dds::Participant participant_{{.network = dds::Network::from_environment({})}};
  Ear<Command> commands_;
  Ear<JointState> frames_;
  Ear<bandwagon_msgs::msg::GroundTruth> truth_;
};

struct Limits {
  double frame = 0.3, motion = 0.25;  ///< [s]
};

void print(const char* what, std::vector<double> seconds, double limit) {
  std::ranges::sort(seconds);
  const auto late = std::ranges::count_if(seconds, [limit](double s) { return s > limit; });
  std::printf("%s: %zu of %zu within %.0f ms, median %.0f ms, worst %.0f ms\n", what,
              seconds.size() - static_cast<std::size_t>(late), seconds.size(), limit * 1e3,
              seconds[seconds.size() / 2] * 1e3, seconds.back() * 1e3);
}

/// A machine that sleeps for 0.3 s looks to the base like wheels that do not turn: it stops for good, as it
/// should.
constexpr int kMaxLatched = 3;

/// Simulated robot, world and base in processes of their own, ended when it goes.
struct SimulatedRobot {
  explicit SimulatedRobot(const std::string& graph)
      : world({BANDWAGON_PROGRAM, "run", graph, "--only", "world", "--for", "36000"}),
        base({BANDWAGON_PROGRAM, "run", graph, "--only", "base", "--for", "36000"}) {}
  ~SimulatedRobot() {
    for (Process* process : {&base, &world}) {
      process->signal(SIGINT);
      process->wait(std::chrono::seconds(20));
    }
  }
  SimulatedRobot(const SimulatedRobot&) = delete;
  SimulatedRobot& operator=(const SimulatedRobot&) = delete;
  bool is_latched() { return base.err().find("until release_stop") != std::string::npos; }

  Process world, base;
};

template <class Command>
int measure(const std::string& program, const std::string& topic, int losses, const Limits& limits) {
  const std::string graph = std::string(BANDWAGON_SOURCE_DIR) + "/tests/faults/" +
                            (topic == "cmd_vel" ? "base_alone.yaml" : "base_commanded.yaml");
  std::optional<SimulatedRobot> robot(std::in_place, graph);
  Trial<Command> trial(topic);
  std::vector<double> frames, motions;
  int failed = 0;
  int latched = 0;
  for (int i = 0; i < losses; ++i) {
    // The phase within the commander's period and the base's: all of both, in an order without a pattern.
    const auto loss = trial.run(program, topic, i % 2 == 0 ? SIGKILL : SIGSTOP, i * 37 % 101);
    if (!loss) {
      std::printf("%d: it did not drive, or did not stop\n%s", i + 1, robot->base.err().c_str());
      if (robot->is_latched() && ++latched <= kMaxLatched) {
        std::printf("%d: the base held it until release_stop, started anew\n", i + 1);
        robot.reset();
        robot.emplace(graph);
        ++losses;
      } else {
        ++failed;
      }
      continue;
    }
    if (loss->is_ambiguous) {
      std::printf("%d: %s while it sent, not judged and not counted\n", i + 1,
                  i % 2 == 0 ? "killed" : "stopped");
      ++losses;
      continue;
    }
    frames.push_back(loss->to_frame);
    motions.push_back(loss->to_motion);
    std::printf("%d: %s, stop frame after %.0f ms, deceleration after %.0f ms\n", i + 1,
                i % 2 == 0 ? "killed" : "silent", loss->to_frame * 1e3, loss->to_motion * 1e3);
    std::fflush(stdout);
  }
  robot.reset();
  if (frames.empty()) return 1;
  print("stop frame", frames, limits.frame);
  print("deceleration", motions, limits.motion);
  const bool is_good = failed == 0 && *std::ranges::max_element(frames) <= limits.frame &&
                       *std::ranges::max_element(motions) <= limits.motion;
  return is_good ? 0 : 1;
}

}  // namespace
}  // namespace bw::test

int main(int argc, char** argv) {
  using namespace bw::test;
  bw::test::Limits limits;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const bool has_value = i + 1 < argc;
    if (std::strcmp(argv[i], "--command") == 0 && has_value) return command(argv[i + 1]);
    if (std::strcmp(argv[i], "--limit-frame") == 0 && has_value) {
      limits.frame = std::atof(argv[++i]) * 1e-3;
    } else if (std::strcmp(argv[i], "--limit-motion") == 0 && has_value) {
      limits.motion = std::atof(argv[++i]) * 1e-3;
    } else {
      words.emplace_back(argv[i]);
    }
  }
  if (words.size() != 2 || (words[0] != "cmd_vel" && words[0] != "wheel_commands")) {
    std::fprintf(
        stderr,
        "usage: lose_commander [--limit-frame MS] [--limit-motion MS] cmd_vel|wheel_commands LOSSES\n");
    return 2;
  }
  const int losses = std::max(1, std::atoi(words[1].c_str()));
  return words[0] == "cmd_vel" ? measure<geometry_msgs::msg::Twist>(argv[0], words[0], losses, limits)
                               : measure<sensor_msgs::msg::JointState>(argv[0], words[0], losses, limits);
}
