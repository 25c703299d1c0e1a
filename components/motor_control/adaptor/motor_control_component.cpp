// Adaptor of motor_control: /cmd_vel in, limited wheel commands out at a steady rate.
#include <optional>
#include <string>

#include <geometry_msgs/msg/twist.hpp>
#include <nav2_msgs/msg/collision_monitor_state.hpp>
#include <std_msgs/msg/bool.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/speed_limit.hpp"
#include "components/messages/wheel_joints.hpp"
#include "components/motor_control/velocity_limiter.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

/// As long as a planner counts that said `brake_hard`: it says so in each of its cycles.
constexpr Duration kHardFor = Duration::milliseconds(300);

struct MotorControlOptions : LimiterOptions {
  double rate = 50.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "Hz", .min = 10, .max = 500, .doc = "wheel commands per second"});
    LimiterOptions::fields(v);
  }
};

class MotorControlComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    const auto options = setup.parameters<MotorControlOptions>(
        [this](const MotorControlOptions& changed, const Tick&) { limiter_->set_options(changed); },
        {"rate"});
    robot_ = setup.shared<Robot>("robot");
    limiter_.emplace(robot_, options);
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    silent_ = setup.failsafe({.name = "command_silent",
                              .condition = "cmd_vel is silent while the robot moves",
                              .debounce = Duration::seconds(options.command_timeout),
                              .recovery = "by itself, with the next command"});
    unusable_ = setup.failsafe({.name = "command_unusable",
                                .condition = "cmd_vel is not finite, or ten times the limits",
                                .recovery = "by itself, with a sound command"});
    wheels_ = setup.command<sensor_msgs::msg::JointState>("wheel_commands");
    setup.input<geometry_msgs::msg::Twist>(
        "cmd_vel", Qos::command(),
        [this](const auto& message, const Tick& tick) { limiter_->command(tick.now, from_twist(message)); });
    namespace monitor = nav2_msgs::msg::CollisionMonitorState_Constants;
    setup.input<nav2_msgs::msg::CollisionMonitorState>(
        "collision_monitor_state", Qos::standard(),
        [this](const auto& message, const Tick&) {
          monitor_acts_ = message.action_type() != monitor::DO_NOTHING;
        },
        Need::optional);
    setup.input<std_msgs::msg::Bool>(
        "brake_hard", Qos::standard(),
        [this](const auto& message, const Tick& tick) {
          hard_at_ = message.data() ? std::optional(tick.now) : std::nullopt;
        },
        Need::optional);
    speed_.listen(setup, robot_.limits);
    setup.every(Duration::seconds(1.0 / options.rate), "wheel_commands",
                [this](const Tick& tick) { step(tick); });
  }

  void deactivate(const Tick& tick) override {
    publish({}, tick.now);
    limiter_->rest();
    last_ = {};
  }

 private:
  bool is_told_hard(Time now) const { return hard_at_ && *hard_at_ <= now && now - *hard_at_ < kHardFor; }

  void step(const Tick& tick) {
    limiter_->allow(speed_.limits());
    limiter_->set_braking(monitor_acts_ || is_told_hard(tick.now) ? Braking::hard : Braking::smooth);
    const LimitedTwist limited =
        tick.health == Health::stop ? limiter_->stop(tick.now) : limiter_->step(tick.now);
    if (limited.state != state_) report(limited);
    state_ = limited.state;
    last_ = limited.twist;
    publish(limited.twist, tick.now);
  }

  /// A robot that stands because nobody drives it is no news for the log.
  void report(const LimitedTwist& limited) {
    using Level = DiagnosticReporter::Level;
    const bool is_fault =
        limited.state == LimiterState::not_finite || limited.state == LimiterState::implausible;
    const bool drives = limited.state == LimiterState::following || limited.state == LimiterState::waiting;
    const std::string text(describe(limited.state));
    unusable_.set(is_fault);
    silent_.set(limited.state == LimiterState::stale && last_ != Twist2{});
    if (is_fault) log_.error("{}: stopping", text);
    if (!is_fault && !drives && last_ != Twist2{}) log_.warn("{}: stopping", text);
    diagnostics_->report(is_fault ? Level::error : drives ? Level::ok : Level::warn, text);
  }

  void publish(const Twist2& twist, Time now) {
    wheels_.publish(
        to_joint_state(to_wheel_speeds(twist, robot_.wheel_separation), robot_.wheel_radii(), now));
  }

  Robot robot_;
  LimitedSpeed speed_;
  std::optional<VelocityLimiter> limiter_;
  LimiterState state_ = LimiterState::waiting;
  bool monitor_acts_ = false;
  std::optional<Time> hard_at_;  ///< when whoever plans asked for hard braking last
  Twist2 last_;
  Failsafe silent_, unusable_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  Output<sensor_msgs::msg::JointState> wheels_;
};

}  // namespace

BW_COMPONENT(MotorControlComponent, "motor_control")

}  // namespace bw
