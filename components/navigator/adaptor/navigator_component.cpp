// Adaptor of the navigator: goals from /goal_pose or the graph, requests to the planners, status for
// everybody.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include <nav_msgs/msg/odometry.hpp>
#include <std_msgs/msg/empty.hpp>

#include "components/messages/geometry.hpp"
#include "components/navigator/adaptor/navigator_messages.hpp"
#include "components/navigator/navigator.hpp"
#include "components/navigator/navigator_parameters.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {
namespace {

using namespace bandwagon_msgs::msg;

class NavigatorComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    parameters_ = setup.parameters<NavigatorParameters>(
        [this](const NavigatorParameters& changed, const Tick&) {
          parameters_ = changed;
          navigator_->set_options(changed);
        },
        {"rate", "goal", "goals", "waypoint_pause", "number_of_loops", "stop_on_failure"});
    navigator_.emplace(parameters_);
    goals_.emplace(parameters_.goal_list());
    log_ = setup.log();
    map_frame_ = setup.frame("map");
    transforms_ = setup.transforms();
    odometry_ = setup.latest<nav_msgs::msg::Odometry>("odometry/filtered", Qos::command());
    plan_request_ = setup.output<PlanRequest>("plan_request");
    follow_request_ = setup.output<FollowRequest>("follow_request");
    status_ = setup.output<NavigationStatus>("navigation_status");
    setup.input<geometry_msgs::msg::PoseStamped>(
        "goal_pose", Qos::standard(), [this](const auto& goal, const Tick& tick) { on_goal(goal, tick); },
        Need::optional);
    setup.input<std_msgs::msg::Empty>(
        "cancel_goal", Qos::standard(), [this](const auto&, const Tick& tick) { cancel(tick); },
        Need::optional);
    setup.input<PlanResult>("plan_result", Qos::standard(), [this](const auto& result, const Tick& tick) {
      navigator_->on_plan(from_message(result), situation(tick));
      send(tick);
    });
    setup.input<FollowStatus>("follow_status", Qos::standard(), [this](const auto& status, const Tick& tick) {
      navigator_->on_follow(from_message(status), situation(tick));
      send(tick);
    });
    setup.every(Duration::seconds(1.0 / parameters_.rate), "step", [this](const Tick& tick) { step(tick); });
  }

  void activate(const Tick& tick) override { goals_->activate(tick.now); }
  void deactivate(const Tick& tick) override { cancel(tick); }

 private:
  void cancel(const Tick& tick) {
    goals_->give_up();
    navigator_->cancel(situation(tick));
    send(tick);
  }

  Situation situation(const Tick& tick) const {
    Situation s{tick.now, std::nullopt, {}};
    if (!odometry_) return s;
    s.twist = from_twist(odometry_->twist().twist());
    const Pose2 X_MB = from_pose(odometry_->pose().pose());
    const bool fresh = (tick.now - odometry_.received()).to_seconds() <= parameters_.pose_timeout;
    if (fresh && tick.health != Health::stop && is_finite(X_MB) && is_finite(s.twist)) s.X_MB = X_MB;
    return s;
  }

  void on_goal(const geometry_msgs::msg::PoseStamped& goal, const Tick& tick) {
    const std::string& frame = goal.header().frame_id();
    const std::optional<Pose2> X_MF =
        frame == map_frame_ ? Pose2{} : transforms_->lookup_planar(map_frame_, frame);
    if (X_MF) {
      if (is_finite(from_pose(goal.pose()))) goals_->give_up();
      navigator_->accept(*X_MF * from_pose(goal.pose()), situation(tick));
    } else {
      navigator_->refuse(from_pose(goal.pose()),
                         "the goal is in frame '" + frame + "', which is not known in '" + map_frame_ + "'");
    }
    send(tick);
  }

  void step(const Tick& tick) {
    send_own_goal(tick);
    send(tick);
    const bool feedback_is_due = (tick.now - last_feedback_).to_seconds() >= parameters_.feedback_period;
    if (navigator_->has_goal() && feedback_is_due) publish(navigator_->report(situation(tick)), tick);
  }

  /// A goal of the graph, as soon as it is known where the robot is.
  void send_own_goal(const Tick& tick) {
    const std::optional<Pose2> X_MG = goals_->due(tick.now);
    if (!X_MG) return;
    const Situation now = situation(tick);
    if (now.X_MB) goals_->taken(navigator_->accept(*X_MG, now));
    constexpr double kPatience = 10.0;  // [s] until a person is told
    if (!now.X_MB && !told_ && (tick.now - goals_->due_since()).to_seconds() > kPatience) {
      log_.warn("the goal waits: no pose on odometry/filtered yet");
      told_ = true;
    }
  }

  void send(const Tick& tick) {
    const NavigatorActions actions = navigator_->step(situation(tick));
    for (const GoalReport& report : actions.reports) {
      log(report, log_);
      publish(report, tick);
    }
    if (actions.follow)
      follow_request_.publish(to_message(*actions.follow, make_header(map_frame_, tick.now)));
    if (actions.plan) plan_request_.publish(to_message(*actions.plan, make_header(map_frame_, tick.now)));
  }

  void publish(const GoalReport& report, const Tick& tick) {
    NavigationStatus message = to_message(report, make_header(map_frame_, tick.now));
    message.number_of_goals_remaining(goals_->see(report, tick.now));
    status_.publish(message);
    last_feedback_ = tick.now;
  }

  NavigatorParameters parameters_;
  std::optional<Navigator> navigator_;
  std::optional<GoalList> goals_;
  Time last_feedback_;
  bool told_ = false;
  Logger log_;
  std::string map_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Latest<nav_msgs::msg::Odometry> odometry_;
  Output<PlanRequest> plan_request_;
  Output<FollowRequest> follow_request_;
  Output<NavigationStatus> status_;
};

}  // namespace

BW_COMPONENT(NavigatorComponent, "navigator")

}  // namespace bw
