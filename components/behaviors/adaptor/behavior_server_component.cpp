// Adaptor of the behaviors: four actions in, one at a time; velocities out. As Nav2's behavior_server.
// Topics: README.md.
#include <memory>
#include <string>
#include <utility>

#include "components/behaviors/adaptor/behavior_goal.hpp"
#include "components/behaviors/adaptor/behavior_messages.hpp"
#include "components/messages/base_stop_source.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/planning_inputs.hpp"
#include "components/messages/velocity_output.hpp"
#include "components/model/robot.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

class BehaviorServerComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<BehaviorOptions>(
        [this](const BehaviorOptions& changed, const Tick&) { options_ = changed; },
        {"cycle_frequency", "enable_stamped_cmd_vel"});
    robot_ = setup.shared<Robot>("robot");
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    inputs_.listen(setup, robot_);
    base_.listen(setup);
    command_.offer(setup, "cmd_vel_behavior",
                   is_stamped(options_.enable_stamped_cmd_vel, setup.ros_distro()));
    with_nav2_layout(setup.ros_distro(), [&](auto layout) {
      using Nav2 = decltype(layout);
      offer<typename Nav2::Spin, SpinMessages>(setup, "spin");
      offer<typename Nav2::BackUp, BackUpMessages>(setup, "backup");
      offer<typename Nav2::DriveOnHeading, DriveOnHeadingMessages>(setup, "drive_on_heading");
      offer<typename Nav2::Wait, WaitMessages>(setup, "wait");
    });
    setup.every(Duration::seconds(1.0 / options_.cycle_frequency), "cycle",
                [this](const Tick& tick) { cycle(tick); });
  }

  void activate(const Tick&) override { report("idle"); }

  /// Goals that are open end by the runtime.
  void deactivate(const Tick& tick) override {
    command_.publish({}, tick.now);
    goal_.reset();
    behavior_.reset();
    is_settled_ = true;
  }

 private:
  template <class A, class Messages>
  void offer(Setup& setup, const std::string& name) {
    using Goal = ActionGoal<A, Messages>;
    setup.action<A>(
        name,
        {.on_goal =
             [this, name](const GoalHandle<A>& handle, const Tick& tick) {
               auto behavior = Messages::behavior(handle.goal(), options_, inputs_.limits(), tick.now);
               start(name, std::make_unique<Goal>(handle, tick.now), std::move(behavior), tick);
             },
         .on_cancel =
             [this](const GoalHandle<A>& handle, const Tick& tick) {
               if (goal_ && goal_->id() == handle.id()) cancel(tick);
             },
         .abandoned =
             [](const std::string& reason) { return Goal::result(BehaviorError::unknown, reason, {}); }});
  }

  /// One at a time, whichever it is.
  void start(const std::string& name, std::unique_ptr<BehaviorGoal> goal, std::unique_ptr<Behavior> behavior,
             const Tick& tick) {
    if (goal_) end(failed(BehaviorError::unknown, "a newer goal came: " + name), tick);
    settle(tick);
    name_ = name;
    goal_ = std::move(goal);
    behavior_ = std::move(behavior);
    report(name);
  }

  void cycle(const Tick& tick) {
    if (!goal_) return settle(tick);
    const BehaviorStep step = behavior_->step(situation(tick));
    step.command ? drive(*step.command, tick) : settle(tick);
    goal_->feedback(step);
    if (step.state == BehaviorStep::State::failed) log_.warn("{}: {}", name_, step.text);
    if (step.state != BehaviorStep::State::running) end(step, tick);
  }

  BehaviorSituation situation(const Tick& tick) const {
    BehaviorSituation situation;
    situation.problem = inputs_.problem(tick.now, situation.missing);
    situation.problem.control_period = 1.0 / options_.cycle_frequency;
    situation.problem.command_lead = options_.command_lead;
    situation.unseen = inputs_.unheard();
    situation.base_stop = base_.at(tick.now);
    if (tick.health == Health::stop) situation.missing = "a needed input is stale";
    return situation;
  }

  void end(const BehaviorStep& step, const Tick& tick) {
    goal_->end(step, tick.now);
    forget();
  }
  void cancel(const Tick& tick) {
    settle(tick);
    goal_->cancel(tick.now);
    forget();
  }
  void forget() {
    goal_.reset();
    behavior_.reset();
    report("idle");
  }

  void drive(const Twist2& twist, const Tick& tick) {
    command_.publish(twist, tick.now);
    if (twist != Twist2{}) drove_at_ = tick.now;
    const auto measured = inputs_.twist();
    const bool stands = measured && is_at_rest(*measured);
    is_settled_ = twist == Twist2{} && (stands || tick.now - drove_at_ > robot_.time_to_rest());
  }
  /// After a motion: zero until the robot stands, and then silence, so that others may drive.
  void settle(const Tick& tick) {
    if (!is_settled_) drive({}, tick);
  }

  void report(const std::string& what) { diagnostics_->report(DiagnosticReporter::Level::ok, what); }

  BehaviorOptions options_;
  Robot robot_;
  PlanningInputs inputs_;
  BaseStopSource base_;
  std::string name_;  ///< of the action whose goal is in hand
  std::unique_ptr<BehaviorGoal> goal_;
  std::unique_ptr<Behavior> behavior_;
  bool is_settled_ = true;  ///< nothing of ours moves the robot
  Time drove_at_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  VelocityOutput command_;
};

}  // namespace

BW_COMPONENT(BehaviorServerComponent, "behavior_server")

}  // namespace bw
