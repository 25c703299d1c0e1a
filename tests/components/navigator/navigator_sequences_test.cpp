// Every sequence of goals, cancels, answers of the planners, lost poses and clock steps through the goal
// state machine. What must hold after each event: every goal has one end and a reason for it, one is in hand
// at most, and the robot is told to drive only along a plan for a goal, towards a pose that is known, and
// never after a cancel.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "components/navigator/navigator.hpp"
#include "tests/exhaustive_sequences.hpp"

namespace bw {
namespace {

NavigatorOptions quick() {
  NavigatorOptions options;
  options.max_recoveries = 2;
  options.max_plan_failures = 2;
  options.wait_time = 1.0;
  options.back_off_time = 1.0;
  options.blocked_patience = 1.0;
  options.lost_patience = 2.0;
  options.movement_time = 3.0;
  return options;
}

struct GoalWorld {
  Situation situation() const {
    Situation s{now, is_lost ? std::nullopt : std::optional(Pose2{x, 0.0, 0.0}), {moves ? 0.5 : 0.0, 0.0}};
    if (base_stands) s.base_stop = {"bumper: left", true};
    return s;
  }

  /// When what happened last, for the state.
  void mark(const std::string& what) { marks[what] = now; }

  void accept(double goal) {
    const std::uint64_t id = navigator.accept({{goal, 0.0, 0.0}, {}}, situation());
    goals[id] = goal;
    cancels = false;
    marks.clear();
    mark("goal");
    failures = 0;
    exchange();
  }
  void accept_nothing() {
    navigator.accept({{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, {}}, situation());
    exchange();
  }
  void refuse() {
    navigator.refuse({}, {GoalFault::unplaced, "nobody knows that frame"});
    exchange();
  }
  void cancel() {
    navigator.cancel(situation());
    if (!cancels) mark("cancel");
    cancels = true;
    exchange();
  }
  void answer(PlanOutcome outcome, const PlanOrder& plan) {
    PlanAnswer answer{.id = plan.id, .outcome = outcome, .reason = "so it is"};
    outcome == PlanOutcome::succeeded ? failures = 0 : ++failures;
    if (outcome == PlanOutcome::succeeded) answer.path = {{x, 0.0, 0.0}, plan.X_MG};
    navigator.on_plan(answer, situation());
    exchange();
  }
  void answer(PlanOutcome outcome) {
    if (asked) answer(outcome, *asked);
  }
  /// Of the order before the newest one.
  void answer_late() {
    if (asked_before) answer(PlanOutcome::succeeded, *asked_before);
  }
  void follow(FollowState state) {
    if (!order) return;
    mark("heard");
    if (state == FollowState::reached)
      marks.erase("stuck");
    else if (!marks.contains("stuck"))
      mark("stuck");
    stuck = state;
    navigator.on_follow({order->id, state, "so it is", 0}, situation());
    exchange();
  }
  void step_back(double seconds) {
    now = now - Duration::seconds(seconds);
    exchange();
  }
  /// The local planner speaks on and on; it drives where it is told to.
  void pass(double seconds, bool speaks) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.25) {
      now = now + Duration::seconds(0.25);
      moves = !base_stands && order && order->mode != FollowMode::stop;
      if (moves && order->mode == FollowMode::follow)
        x += std::clamp(order->path.back().x - x, -0.125, 0.125);
      if (moves && order->mode == FollowMode::back_off) x -= 0.05;
      if (speaks) mark("heard");
      if (speaks) marks.erase("stuck");
      if (speaks && order) navigator.on_follow({order->id, FollowState::following, "", 0}, situation());
      exchange();
    }
    moves = !base_stands && order && order->mode != FollowMode::stop;
  }

  void exchange() {
    const NavigatorActions actions = navigator.step(situation());
    for (const GoalReport& report : actions.reports) see(report);
    if (actions.follow) see(*actions.follow);
    if (actions.plan) {
      if (asked && actions.plan->id <= asked->id) violation = "a plan is asked for with an old id";
      if (!navigator.has_goal() || cancels) violation = "a plan is asked for without a goal";
      mark("asked");
      asked_before = asked;
      asked = actions.plan;
    }
    judge();
  }

  void see(const GoalReport& report) {
    if (ended.contains(report.goal_id)) violation = "a report after the end of the goal";
    if (!is_final(report.status)) {
      in_hand = report.goal_id;
      mark("status");
      return;
    }
    if (report.reason.empty()) violation = "an end without a reason";
    if (report.status == GoalStatus::aborted && report.fault == GoalFault::none)
      violation = "aborted without a fault";
    ended[report.goal_id] = report.status;
    if (in_hand == report.goal_id) in_hand.reset();
  }

  void see(const FollowOrder& given) {
    if (order && given.id <= order->id) violation = "an order with an old id";
    if (!order || order->mode != given.mode) mark("mode");
    mark("order");
    order = given;
    if (given.mode == FollowMode::stop) return;
    if (!in_hand) violation = "told to drive without a goal";
    if (cancels) violation = "told to drive after a cancel";
    if (is_lost) violation = "told to drive without a pose";
    if (given.mode == FollowMode::follow && in_hand && given.path.back().x != goals[*in_hand])
      violation = "told to drive to another goal";
  }

  void judge() {
    const bool drives = order && order->mode != FollowMode::stop;
    if (in_hand.has_value() != navigator.has_goal()) violation = "a goal without an end is not in hand";
    if (in_hand && *in_hand != navigator.goal_id()) violation = "another goal is in hand";
    if (!in_hand && drives) violation = "drives on after the end";
    if (cancels && drives) violation = "drives on after a cancel";
    if (is_lost && drives && in_hand) violation = "drives on without a pose";
    for (const auto& [id, goal] : goals) {
      if (id != navigator.goal_id() && !ended.contains(id)) violation = "a goal was forgotten";
    }
    const GoalReport report = navigator.report(situation());
    if (in_hand && report.status == GoalStatus::executing && !drives && !asked && report.reason.empty())
      violation = "stands without a reason";
    if (in_hand && report.status == GoalStatus::executing && base_stands && !is_lost && report.reason.empty())
      violation = "the base stands, and the status does not say so";
    const GoalFault hindrance = navigator.hindrance(situation()).fault;
    if ((hindrance == GoalFault::base_stands) != (base_stands && (!in_hand || cancels)))
      violation = "another goal is hindered, or is not, though the base stands";
  }

  Navigator navigator{quick()};
  Time now = Time::seconds(100.0);
  double x = 0.0;
  bool is_lost = false, moves = false, cancels = false, base_stands = false;
  std::optional<std::uint64_t> in_hand;
  std::map<std::uint64_t, double> goals;
  std::map<std::uint64_t, GoalStatus> ended;
  std::optional<PlanOrder> asked, asked_before;
  std::optional<FollowOrder> order;
  std::string violation;

  std::map<std::string, Time> marks;
  int failures = 0;
  FollowState stuck = FollowState::idle;

  /// Ages, what is in hand, and what was said of it. How far the robot has come since is in its place.
  std::string state() const {
    char text[200];
    const GoalReport report = navigator.report(situation());
    std::snprintf(text, sizeof text, "%.3f %d%d%d%d %d %d %d %u %d %d %d ", x, is_lost, moves, cancels,
                  base_stands, in_hand ? static_cast<int>(goals.at(*in_hand)) : 0,
                  order ? static_cast<int>(order->mode) : -1, static_cast<int>(report.status),
                  report.recoveries, failures, static_cast<int>(stuck),
                  asked ? static_cast<int>(asked->X_MG.x) : -1);
    std::string all = text + report.reason.substr(0, report.reason.find(" goal "));
    for (const auto& [what, when] : marks) {
      const Duration age =
          std::clamp(now - when, Duration::milliseconds(-1000), Duration::milliseconds(12'000));
      all += ' ' + what + std::to_string(age.nanoseconds / 250'000'000);
    }
    if (asked_before && asked) all += asked_before->X_MG.x == asked->X_MG.x ? " =" : " !";
    return all;
  }
};

TEST(Navigator, GivesEachGoalOneEndAndDrivesForOneGoalInEverySequence) {
  const auto goal = [](double x) { return [=](GoalWorld& w) { w.accept(x); }; };
  const auto plan = [](PlanOutcome outcome) { return [=](GoalWorld& w) { w.answer(outcome); }; };
  const auto follow = [](FollowState state) { return [=](GoalWorld& w) { w.follow(state); }; };
  const auto after = [](double s, bool speaks) { return [=](GoalWorld& w) { w.pass(s, speaks); }; };
  const auto lost = [](bool is_lost) {
    return [=](GoalWorld& w) {
      w.is_lost = is_lost;
      w.exchange();
    };
  };
  const auto base = [](bool stands) {
    return [=](GoalWorld& w) {
      if (w.base_stands != stands) w.mark("base");
      w.base_stands = stands;
      w.exchange();
    };
  };
  const test::Sequences<GoalWorld> sequences{
      .make = [] { return GoalWorld{}; },
      .events = {{"goal at 1 m", goal(1.0)},
                 {"goal at 5 m", goal(5.0)},
                 {"goal that is no pose", [](GoalWorld& w) { w.accept_nothing(); }},
                 {"goal in a strange frame", [](GoalWorld& w) { w.refuse(); }},
                 {"cancel", [](GoalWorld& w) { w.cancel(); }},
                 {"plan", plan(PlanOutcome::succeeded)},
                 {"no way", plan(PlanOutcome::disconnected)},
                 {"start blocked", plan(PlanOutcome::start_blocked)},
                 {"bad request", plan(PlanOutcome::bad_request)},
                 {"plan of before", [](GoalWorld& w) { w.answer_late(); }},
                 {"blocked", follow(FollowState::blocked)},
                 {"failed", follow(FollowState::failed)},
                 {"reached", follow(FollowState::reached)},
                 {"lost", lost(true)},
                 {"found", lost(false)},
                 {"the base stands", base(true)},
                 {"the base obeys", base(false)},
                 {"2 s", after(2.0, true)},
                 {"1.5 s of silence", after(1.5, false)},
                 {"10 s", after(10.0, true)},
                 {"clock back 1 s", [](GoalWorld& w) { w.step_back(1.0); }},
                 {"clock back 60 s", [](GoalWorld& w) { w.step_back(60.0); }}},
      .broken = [](const GoalWorld& world) { return world.violation; },
      .state = [](const GoalWorld& world) { return world.state(); }};
  test::expect_unbroken("navigator", sequences, test::sequence_depth(7));
}

}  // namespace
}  // namespace bw
