// Adaptor of the base: wheel commands to the driver under the watchdog, encoder counts to odometry, joint
// states and tf.
#include <memory>
#include <optional>

#include "components/messages/odometry_outputs.hpp"
#include "components/messages/wheel_joints.hpp"
#include "components/robot_base/adaptor/chosen_driver.hpp"
#include "components/robot_base/wheel_watchdog.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

struct RobotBaseOptions {
  OdometryOptions odometry;
  WatchdogOptions watchdog;

  template <class Visitor>
  void fields(Visitor& v) {
    v("odometry", odometry, {.doc = "from encoder counts to pose and twist"});
    v("watchdog", watchdog, {.doc = "the stop when wheel commands stop"});
  }
};

class RobotBaseComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    const auto options = setup.parameters<RobotBaseOptions>();
    robot_ = setup.shared<Robot>("robot");
    odometry_.emplace(robot_, options.odometry);
    watchdog_.emplace(options.watchdog, robot_.limits.stop_deceleration);
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    outputs_ = {setup, robot_};
    joints_ = setup.output<sensor_msgs::msg::JointState>("joint_states");
    driver_ = make_chosen_driver(setup, robot_, [this](Time now) { poll(now); });
    setup.input<sensor_msgs::msg::JointState>(
        "wheel_commands", Qos::command(),
        [this](const auto& message, const Tick& tick) { on_command(message, tick); });
    setup.every(Duration::milliseconds(10), "watchdog", [this](const Tick& tick) {
      poll(tick.now);
      check(tick);
    });
  }

  void activate(const Tick& tick) override { outputs_.publish_mounts(tick.now); }

  void deactivate(const Tick& tick) override { driver_->stop(tick.now); }

 private:
  void on_command(const sensor_msgs::msg::JointState& message, const Tick& tick) {
    const std::optional<WheelSpeeds> wheels = wheel_speeds_of(message, robot_.wheel_radius);
    const bool is_sound = wheels && watchdog_->command(tick.now, *wheels);
    if (refused_.is_news(is_sound ? "" : "unsound") && !is_sound) {
      log_.warn("refused a wheel command that is not two finite rates of {} and {}", wheel_joint_names()[0],
                wheel_joint_names()[1]);
    }
    if (is_sound) check(tick);
  }

  void check(const Tick& tick) {
    if (tick.health == Health::stop) watchdog_->revoke(tick.now);
    const WatchdogOutput output = watchdog_->step(tick.now);
    driver_->command(tick.now, output.wheels);
    if (!sent_ || sent_->state != output.state) report(output.state);
    sent_ = output;
  }

  void report(WatchdogState state) {
    using Level = DiagnosticReporter::Level;
    if (state == WatchdogState::obeying) diagnostics_->report(Level::ok, "obeying wheel commands");
    if (state == WatchdogState::stopping) log_.warn("no fresh wheel command: stopping");
    if (state == WatchdogState::stopping)
      diagnostics_->report(Level::error, "wheel commands stopped: stopping");
    if (state == WatchdogState::stopped)
      diagnostics_->report(Level::warn, "standing: wheel commands stopped");
  }

  void poll(Time now) {
    const Readings readings = driver_->poll(now);
    for (const EncoderCounts& counts : readings.counts) on_counts(counts);
  }

  void on_counts(const EncoderCounts& counts) {
    const CountsStatus status = odometry_->add(counts);
    const bool is_fault = status == CountsStatus::jump || status == CountsStatus::reset;
    // At most a line a second: encoders that fail do so at every reading.
    if (is_fault && (!fault_told_ || counts.time - *fault_told_ >= Duration::milliseconds(1000))) {
      fault_told_ = counts.time;
      log_.warn("encoder {} dropped (jumps {}, resets {})", status == CountsStatus::jump ? "jump" : "reset",
                odometry_->faults().jumps, odometry_->faults().resets);
    }
    if (status != CountsStatus::stale) publish(odometry_->state());
  }

  void publish(const OdometryState& state) {
    outputs_.publish_odometry(state);
    const WheelSpeeds wheels = to_wheel_speeds(state.twist, robot_.wheel_separation);
    sensor_msgs::msg::JointState joints = to_joint_state(wheels, robot_.wheel_radius, state.time);
    joints.position({state.left_angle, state.right_angle});
    joints_.publish(joints);
    outputs_.publish_transform(state);
  }

  Robot robot_;
  std::optional<EncoderOdometry> odometry_;
  std::optional<WheelWatchdog> watchdog_;
  std::optional<WatchdogOutput> sent_;
  std::unique_ptr<Driver> driver_;
  Complaint refused_;
  std::optional<Time> fault_told_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  OdometryOutputs outputs_;
  Output<sensor_msgs::msg::JointState> joints_;
};

}  // namespace

BW_COMPONENT(RobotBaseComponent, "robot_base")

}  // namespace bw
