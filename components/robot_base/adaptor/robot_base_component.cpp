// Adaptor of the base: wheel commands to the driver as the guard allows, and what the driver tells to topics.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <std_msgs/msg/empty.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "components/robot_base/adaptor/base_failsafes.hpp"
#include "components/robot_base/adaptor/base_outputs.hpp"
#include "components/robot_base/adaptor/chosen_driver.hpp"
#include "components/robot_base/adaptor/emergency_stop_inputs.hpp"
#include "components/robot_base/adaptor/odometry_reader.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using std_srvs::srv::Trigger;

/// Wheel commands are said anew 50 times a second: one that is lost is not asked for again, which saves a
/// reply for each.
constexpr Qos kNewest{.reliability = Reliability::best_effort, .depth = 1};

struct RobotBaseOptions : BaseGuardOptions {
  OdometryOptions odometry;
  EmergencyStopOptions emergency_stop;

  template <class Visitor>
  void fields(Visitor& v) {
    v("odometry", odometry, {.doc = "from encoder counts to pose and twist"});
    v("emergency_stop", emergency_stop, {.doc = "who presses it; others may press it as well"});
    BaseGuardOptions::fields(v);
  }
};

Trigger::Response trigger_response(bool success, const std::string& message) {
  Trigger::Response response;
  response.success(success);
  response.message(message);
  return response;
}

class RobotBaseComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    auto options = setup.parameters<RobotBaseOptions>();
    robot_ = setup.shared<Robot>("robot");
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    driver_ = make_chosen_driver(setup, robot_, [this](Time now) { work(now); });
    const BaseFacts facts = driver_->facts();
    options.odometry.velocity_window = std::max(options.odometry.velocity_window, facts.velocity_window);
    odometry_ = {setup, robot_, options.odometry, Duration::seconds(options.link.silence)};
    if (options.battery.low == 0.0) options.battery.low = facts.battery_low;
    if (options.battery.empty == 0.0) options.battery.empty = facts.battery_empty;
    guard_.emplace(options, robot_, facts.response);
    keepsake_ = setup.keepsake("base");
    if (!keepsake_.left().empty()) guard_->takes_over();
    failsafes_ = {setup, options};
    outputs_ = {setup, *driver_};
    setup.input<sensor_msgs::msg::JointState>(
        "wheel_commands", kNewest,
        [this](const auto& message, const Tick& tick) { on_command(message, tick); });
    released_ = setup.output<std_msgs::msg::Empty>("stop_released");
    emergency_stop_options_ = options.emergency_stop;
    emergency_stop_ = setup.part_of_node<EmergencyStopInputs>();
    setup.service<Trigger>(
        "release_stop", [this](const Trigger::Request&, const Tick& tick) { return release(tick.now); },
        [](const std::string& reason) { return trigger_response(false, reason); });
    setup.every(Duration::milliseconds(10), "watchdog", [this](const Tick& tick) {
      is_stopped_ = tick.health == Health::stop;
      work(tick.now);
    });
    setup.every(Duration::milliseconds(100), "base_state", [this](const Tick& tick) {
      emergency_stop_->name();
      publish_state(tick.now);
      if (tick.sequence % 10 == 0) tell_counters();
    });
  }

  void activate(const Tick& tick) override {
    odometry_.publish_mounts(tick.now);
    keepsake_.keep("it was there\n");
    emergency_stop_->begin(tick.now, emergency_stop_options_, [this](Time now) { obey(now); });
  }

  void deactivate(const Tick& tick) override {
    emergency_stop_->end();
    driver_->stop(tick.now);
  }

 private:
  void on_command(const sensor_msgs::msg::JointState& message, const Tick& tick) {
    const std::optional<WheelSpeeds> wheels = wheel_speeds_of(message, robot_.wheel_radii());
    const bool is_sound = wheels && guard_->command(tick.now, *wheels);
    if (refused_.is_news(is_sound ? "" : "unsound") && !is_sound) {
      log_.warn("refused a wheel command that is not two finite rates of {} and {}", wheel_joint_names()[0],
                wheel_joint_names()[1]);
    }
    is_stopped_ = tick.health == Health::stop;
    if (is_sound) obey(tick.now);
  }

  void work(Time now) {
    const Readings readings = driver_->poll(now);
    guard_->read(now, readings);
    for (const EncoderCounts& counts : readings.counts) {
      if (const auto travel = odometry_.read(now, counts)) guard_->moved(counts.time, *travel);
    }
    outputs_.publish(now, readings);
    if (warning_.is_news(readings.warning) && warning_) log_.warn("{}", readings.warning);
    obey(now);
  }

  void obey(Time now) {
    if (is_stopped_) guard_->revoke();
    emergency_stop_->step(now);
    guard_->set_emergency_stop(emergency_stop_->stop().is_latched(), emergency_stop_->stop().reason());
    const BaseOutput output = guard_->step(now);
    guard_->told(now, output.wheels, driver_->command(now, output.wheels));
    const bool is_news = output.condition != told_.condition || output.reason != told_.reason ||
                         output.is_latched != told_.is_latched || output.commands != told_.commands;
    const bool is_contact = guard_->contacts() != contacts_;
    const bool is_battery = guard_->battery() != battery_;
    told_ = output;
    failsafes_.show(output);
    contacts_ = guard_->contacts();
    battery_ = guard_->battery();
    if (is_news || is_battery) report(output);
    if (is_news || is_contact || outputs_.is_news()) publish_state(now);
  }

  void publish_state(Time now) { outputs_.publish_state(now, told_, contacts_, odometry_.measured()); }

  /// All or nothing: what another cause refuses leaves the emergency stop latched, too.
  Trigger::Response release(Time now) {
    auto refusal = emergency_stop_->refusal();
    if (!refusal) {
      guard_->set_emergency_stop(false);
      refusal = guard_->release();
    }
    if (refusal) {
      log_.warn("release_stop is refused: {}", *refusal);
      return trigger_response(false, *refusal);
    }
    const std::string left = emergency_stop_->release();
    const std::string said = left.empty() ? "" : "; " + left;
    log_.info("stops are released{}", said);
    released_.publish({});
    obey(now);
    const std::string& next = told_.reason.empty() ? "it drives at the next command" : told_.reason;
    return trigger_response(true, "released: " + next + said);
  }

  void report(const BaseOutput& output) {
    using Level = DiagnosticReporter::Level;
    if (!output.reason.empty()) {
      const std::string how = output.is_latched ? "; until release_stop" : "";
      if (complaint_.is_news(output.reason + how)) log_.warn("{}{}", output.reason, how);
      const bool is_stop = output.condition != BaseCondition::waiting;
      return diagnostics_->report(is_stop ? Level::error : Level::warn, output.reason + how);
    }
    if (complaint_.is_news("")) log_.info("nothing keeps the base from driving any more");
    if (output.commands == WatchdogState::stopping) log_.warn("no fresh wheel command: stopping");
    const std::string& warning = battery_ == BatteryLevel::low ? "the battery is low" : warning_.what();
    if (output.commands == WatchdogState::obeying)
      diagnostics_->report(warning.empty() ? Level::ok : Level::warn,
                           "obeying wheel commands" + (warning.empty() ? "" : "; " + warning));
    if (output.commands == WatchdogState::stopping)
      diagnostics_->report(Level::error, "wheel commands stopped: stopping");
    if (output.commands == WatchdogState::stopped)
      diagnostics_->report(Level::warn, "standing: wheel commands stopped");
  }

  void tell_counters() {
    if (!outputs_.device().empty()) diagnostics_->set_value("device", outputs_.device());
    for (const auto& [name, count] : driver_->counters())
      diagnostics_->set_value(name, std::to_string(count));
  }

  Robot robot_;
  OdometryReader odometry_;
  std::unique_ptr<Driver> driver_;
  std::optional<BaseGuard> guard_;
  Output<std_msgs::msg::Empty> released_;  ///< each release, for whoever waits for one as well
  std::shared_ptr<EmergencyStopInputs> emergency_stop_;
  EmergencyStopOptions emergency_stop_options_;
  BaseOutputs outputs_;
  BaseOutput told_;
  BaseFailsafes failsafes_;
  Keepsake keepsake_;
  ContactReading contacts_;
  BatteryLevel battery_ = BatteryLevel::good;
  bool is_stopped_ = false;  ///< the runtime asks for a stop
  Complaint refused_, complaint_, warning_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
};

}  // namespace

BW_COMPONENT(RobotBaseComponent, "robot_base")

}  // namespace bw
