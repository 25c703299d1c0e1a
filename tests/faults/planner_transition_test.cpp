// The local planner is taken away at full speed, through its lifecycle, and given back: the robot stands
// meanwhile and drives on afterwards. Straight on at 1 m/s, in virtual time.
//
// Deactivating, the planner commands standstill, and motor_control brakes: at 1 m/s^2 with a jerk of 5 m/s^3
// that takes
// 1.0 + 0.2 s; commands of an older planner are 200 ms old at most. So it stands within 1.5 s.
#include <map>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <gtest/gtest.h>
#include <lifecycle_msgs/srv/change_state.hpp>

#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"

namespace bw {
namespace {

using lifecycle_msgs::srv::ChangeState;

constexpr double kTaken = 5.0;   // [s] after the start
constexpr double kGiven = 10.0;  // [s]

struct Drive {
  double speed_before = 0.0;          ///< when the planner is taken [m/s]
  std::optional<double> stood_after;  ///< [s] since then
  double fastest_while_away = 0.0;    ///< from 1.5 s after it on [m/s]
  double speed_at_end = 0.0;          ///< [m/s]
  int refused = 0;                    ///< transitions
};

/// Asks for one transition after the other at a time, and looks how the robot moves.
class Taker final : public Component {
 public:
  Taker(std::map<double, std::string> transitions, Drive& drive)
      : transitions_(std::move(transitions)), drive_(drive) {}

  void configure(Setup& setup) override {
    planner_ = setup.client<ChangeState>("/local_planner/change_state", Need::optional);
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "sim/ground_truth", Qos::command(),
        [this](const auto& truth, const Tick& tick) { look(seconds(tick), truth.twist().linear().x()); });
    setup.every(Duration::milliseconds(10), "take", [this](const Tick& tick) {
      while (!transitions_.empty() && transitions_.begin()->first <= seconds(tick)) {
        ask(transitions_.begin()->second);
        transitions_.erase(transitions_.begin());
      }
    });
  }

 private:
  static double seconds(const Tick& tick) { return (tick.now - LockstepRunner::kStart).to_seconds(); }

  void ask(const std::string& transition) {
    ChangeState::Request request;
    request.transition().label(transition);
    planner_.call(request, Duration::seconds(1.0), [this](const auto* response, const Tick&) {
      if (response == nullptr || !response->success()) ++drive_.refused;
    });
  }

  void look(double t, double v) {
    if (t < kTaken) drive_.speed_before = v;
    if (t > kTaken && !drive_.stood_after && v < 0.001) drive_.stood_after = t - kTaken;
    if (t > kTaken + 1.5 && t < kGiven) drive_.fastest_while_away = std::max(drive_.fastest_while_away, v);
    drive_.speed_at_end = v;
  }

  std::map<double, std::string> transitions_;
  Drive& drive_;
  Client<ChangeState> planner_;
};

Drive drive(std::map<double, std::string> transitions) {
  Drive result;
  std::vector<ExtraComponent> extra;
  extra.push_back({"taker", std::make_unique<Taker>(std::move(transitions), result)});
  Host host(load_graph(std::string(BANDWAGON_SOURCE_DIR) + "/tests/faults/straight_drive.yaml"),
            {.clock = ClockMode::lockstep, .seed = 3}, std::move(extra));
  host.run(Duration::seconds(kGiven + 8.0));  // the navigator backs off first, as it lacks a planner
  return result;
}

void expect_a_stop_and_a_second_drive(const Drive& drive) {
  EXPECT_EQ(drive.refused, 0);
  EXPECT_GT(drive.speed_before, 0.9) << "it was driving";
  ASSERT_TRUE(drive.stood_after);
  EXPECT_LT(*drive.stood_after, 1.5);
  EXPECT_LT(drive.fastest_while_away, 0.001);
  EXPECT_GT(drive.speed_at_end, 0.9) << "it drives again";
}

TEST(PlannerTransition, DeactivatedWhileDrivingTheRobotStands) {
  expect_a_stop_and_a_second_drive(drive({{kTaken, "deactivate"}, {kGiven, "activate"}}));
}

TEST(PlannerTransition, AnotherInstanceDrivesOn) {
  expect_a_stop_and_a_second_drive(drive({{kTaken, "deactivate"},
                                          {kTaken + 0.2, "cleanup"},
                                          {kGiven - 0.1, "configure"},
                                          {kGiven, "activate"}}));
}

TEST(PlannerTransition, ShutDownItIsGoneForGood) {
  const Drive gone = drive({{kTaken, "shutdown"}});
  ASSERT_TRUE(gone.stood_after);
  EXPECT_LT(*gone.stood_after, 1.5);
  EXPECT_LT(gone.fastest_while_away, 0.001);
  EXPECT_LT(gone.speed_at_end, 0.001);
}

}  // namespace
}  // namespace bw
