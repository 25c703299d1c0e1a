// Measures what happens after SIGKILL of the planning process at top speed: three processes on the wall
// clock, as `bandwagon launch` starts them. Prints, per trial, the time from the last command to the
// first deceleration and to standstill. A measurement, not a test: the same contract is asserted in virtual
// time by command_loss_test.cpp.
//   kill_planner [TRIALS]
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime/dds/participant.hpp"
#include "runtime/wire/serialization.hpp"

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

class Process {
 public:
  explicit Process(const char* name) : pid_(fork()) {
    if (pid_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);  // no orphans, however this program ends
      execl(BANDWAGON_PROGRAM, "bandwagon", "run", BANDWAGON_SOURCE_DIR "/tests/faults/straight_drive.yaml",
            "--only", name, "--set",
            "robot.limits.v_max=1.06",  // the band keeps 0.05 m/s from its limit
            nullptr);
      _exit(127);
    }
  }
  ~Process() { end(SIGINT); }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  void end(int signal) {
    if (pid_ <= 0) return;
    kill(pid_, signal);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }

 private:
  pid_t pid_;
};

template <class M>
class Listener {
 public:
  Listener(bw::dds::Participant& participant, const std::string& topic)
      : reader_(participant.create_reader({.topic = topic,
                                           .type = std::string(bw::MessageTraits<M>::dds_name),
                                           .qos = bw::Qos::standard(100),
                                           .user_data = {}},
                                          [] {})) {}
  std::optional<M> next() {
    M message;
    if (!reader_->take(sample_) || !bw::deserialize(sample_.cdr, message)) return std::nullopt;
    return message;
  }

 private:
  bw::dds::Sample sample_;
  std::unique_ptr<bw::dds::Reader> reader_;
};

struct Trial {
  double speed = 0.0;
  double to_deceleration_s = 0.0;
  double to_standstill_s = 0.0;
};

std::optional<Trial> run_trial() {
  bw::dds::Participant participant(
      {.network = bw::dds::Network::from_environment(bw::dds::Transport::localhost)});
  Listener<bandwagon_msgs::msg::GroundTruth> truth(participant, "rt/sim/ground_truth");
  Listener<geometry_msgs::msg::Twist> commands(participant, "rt/cmd_vel");
  const Process base("world+base");
  const Process rest("rest");
  Process planning("planning");

  Trial trial;
  Clock::time_point last_command{};
  std::optional<Clock::time_point> killed;
  std::optional<Clock::time_point> braking_since;
  const auto give_up = Clock::now() + std::chrono::seconds(30);
  while (Clock::now() < give_up) {
    std::this_thread::sleep_for(milliseconds(1));
    while (commands.next()) last_command = Clock::now();
    while (const auto t = truth.next()) {
      const double v = t->twist().linear().x();
      const auto now = Clock::now();
      if (!braking_since) trial.speed = std::max(trial.speed, v);  // it may still gain after the last command
      if (!killed && v > 0.97) {
        killed = now;
        planning.end(SIGKILL);
      } else if (killed && !braking_since && v < trial.speed - 0.02) {  // 10 ms of braking; noise is below
        braking_since = now;
        trial.to_deceleration_s = seconds_between(last_command, now);
      } else if (braking_since && std::abs(v) < 0.005) {
        trial.to_standstill_s = seconds_between(last_command, now);
        return trial;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  const int trials = argc > 1 ? std::atoi(argv[1]) : 20;
  int good = 0;
  for (int i = 0; i < trials; ++i) {
    const auto trial = run_trial();
    if (!trial) {
      std::printf("%2d: the robot did not reach its speed or did not stop\n", i + 1);
      continue;
    }
    const bool ok = trial->to_deceleration_s <= 0.25 && trial->to_standstill_s <= 1.0;
    good += ok ? 1 : 0;
    std::printf("%2d: at %.2f m/s, last command to deceleration %.0f ms, to standstill %.0f ms%s\n", i + 1,
                trial->speed, trial->to_deceleration_s * 1e3, trial->to_standstill_s * 1e3,
                ok ? "" : "  (late)");
    std::fflush(stdout);
  }
  std::printf("%d of %d within 250 ms and 1.0 s\n", good, trials);
  return good == trials ? 0 : 1;
}
