// Adaptor of the collision monitor: sweeps, odometry and wanted velocities in, allowed velocities out.
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nav2_msgs/msg/collision_monitor_state.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <std_msgs/msg/empty.hpp>

#include "components/messages/current_footprint.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/laser.hpp"
#include "components/messages/velocity_output.hpp"
#include "components/safety/adaptor/limited_share.hpp"
#include "components/safety/adaptor/scan_frames.hpp"
#include "components/safety/adaptor/zone_markers.hpp"
#include "components/safety/collision_monitor.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using safety::Action;
using safety::Verdict;

constexpr double kAtRest = 0.01;  // [m/s], [rad/s]
constexpr Duration kCycle = Duration::milliseconds(20);
constexpr Duration kMarkerPeriod = Duration::milliseconds(200);
constexpr std::string_view kCommandSilent = "command_silent";
constexpr std::string_view kInputStale = "input_stale";

bool moves(const Twist2& twist) { return std::abs(twist.v) > kAtRest || std::abs(twist.omega) > kAtRest; }

class CollisionMonitorComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<safety::CollisionMonitorOptions>(
        [this](const safety::CollisionMonitorOptions& changed, const Tick&) { use(changed); },
        {"enable_stamped_cmd_vel", "source_timeout", "resume", "sweep"});
    robot_ = setup.shared<Robot>("robot");
    monitor_.emplace(robot_, options_);
    footprint_.listen(setup, robot_, [this](const Footprint& now) { monitor_->set_footprint(now); });
    for (SensorMount& mount : robot_.sensors) mount.frame = setup.frame(mount.frame);
    base_frame_ = setup.frame("base_link");
    frames_ = {robot_, base_frame_, setup.log()};
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    const bool stamped = is_stamped(options_.enable_stamped_cmd_vel, setup.ros_distro());
    command_.offer(setup, "cmd_vel", stamped);
    declare_failsafes(setup);
    state_ = setup.output<nav2_msgs::msg::CollisionMonitorState>("collision_monitor_state");
    markers_ = setup.output<visualization_msgs::msg::MarkerArray>("collision_monitor_markers");
    setup.input<sensor_msgs::msg::LaserScan>(
        "scan", Qos::sensor(), [this](const auto& message, const Tick& tick) { on_scan(message, tick); });
    setup.input<nav_msgs::msg::Odometry>(
        "odom", Qos::sensor(), [this](const auto& message, const Tick& tick) {
          monitor_->odometry(tick.now, from_pose(message.pose().pose()), from_twist(message.twist().twist()));
        });
    input_velocity(setup, "cmd_vel_nav", stamped, [this](const Twist2& wanted, const Tick& tick) {
      wanted_ = wanted;
      wanted_at_ = tick.now;
      pass_on(tick);
    });
    const auto reset = [this](const auto&, const Tick&) { monitor_->reset(); };
    setup.input<std_msgs::msg::Empty>("collision_monitor/reset", Qos::standard(), reset, Need::optional);
    setup.every(kCycle, "limit", [this](const Tick& tick) { pass_on(tick); });
  }

  void deactivate(const Tick& tick) override {
    command_.publish({}, tick.now);
    wanted_at_.reset();  // what was wanted before counts no more
    last_ = {};
    if (limited_.cycles() > 0) log_.info("limited in {}", limited_.text());
  }

 private:
  void declare_failsafes(Setup& setup) {
    const std::string recovery = options_.resume == safety::Resume::manual
                                     ? "by collision_monitor/reset"
                                     : "by itself, with the next sound sweep";
    const Duration timeout = Duration::seconds(options_.source_timeout);
    using Row = std::pair<std::string_view, const char*>;
    for (const auto& [cause, condition] :
         {Row{safety::kLaserSilent, "scan is silent"},
          Row{safety::kLaserFrozen, "the same sweep again while wheels turn"},
          Row{safety::kLaserInvalid, "sweeps are none, or late"}})
      laser_failsafes_[cause] =
          setup.failsafe({.name = std::string(cause),
                          .condition = condition,
                          .debounce = cause == safety::kLaserSilent ? timeout : Duration{},
                          .recovery = recovery});
    dark_failsafe_ = setup.failsafe({.name = "laser_dark",
                                     .condition = "what was seen has vanished from a sector",
                                     .action = FailsafeAction::slow,
                                     .recovery = "by itself, once the laser hits something there"});
    silent_failsafe_ = setup.failsafe({.name = std::string(kCommandSilent),
                                       .condition = "cmd_vel_nav is silent while the robot moves",
                                       .debounce = Duration::seconds(options_.command_timeout),
                                       .recovery = "by itself, with the next command"});
  }

  void use(const safety::CollisionMonitorOptions& changed) {
    options_ = changed;
    monitor_->set_options(changed);
    last_.cause = "";  // it may have been the name of a zone
  }

  void on_scan(const sensor_msgs::msg::LaserScan& message, const Tick& tick) {
    const std::string& frame = message.header().frame_id();
    const LaserSweep sweep = to_sweep(message, robot_.mount_of(frame));
    if (frames_.is_placed(frame)) {
      monitor_->sweep(tick.now, sweep, {tick.from.writer, tick.from.is_own_clock, robot_.delay_of(frame)});
      if (monitor_->stamp().has_stepped)
        log_.warn("scan: the clock that stamps it was set, or all sweeps before were late");
    } else {
      monitor_->refuse(tick.now, sweep, SweepFault::unplaced);
    }
    tell_dark();
    if (wanted_at_) pass_on(tick);
  }

  Verdict judge(const Tick& tick) {
    if (tick.health == Health::stop) return {{}, Action::stop, kInputStale};
    if (tick.now - *wanted_at_ > Duration::seconds(options_.command_timeout))
      return {{}, Action::stop, kCommandSilent};
    return monitor_->judge(tick.now, wanted_);
  }

  /// Says nothing to a robot that stands and that nobody drives.
  void pass_on(const Tick& tick) {
    monitor_->look(tick.now);
    if (!wanted_at_) return;
    if (*wanted_at_ > tick.now) {  // the clock went back: how old it is nobody knows
      wanted_ = {};
      wanted_at_ = tick.now;
    }
    const Verdict verdict = judge(tick);
    const bool silent = verdict.cause == kCommandSilent && !moves(monitor_->actual());
    if (!silent || moves(last_.allowed)) publish(verdict, tick.now);
    if (moves(verdict.allowed) && !std::exchange(has_driven_, true) && !monitor_->has_seen())
      log_.warn("the laser has hit nothing since the start: an open place, or it does not work");
    const bool counts = moves(wanted_) && verdict.cause != kCommandSilent;
    if (counts) limited_.count(verdict.action != Action::do_nothing);
    if (silent != idle_ || verdict.action != last_.action || verdict.cause != last_.cause)
      report(verdict, silent);
    idle_ = silent;
    last_ = verdict;
    if (markers_.has_readers() &&
        (!drawn_at_ || tick.now - *drawn_at_ >= kMarkerPeriod || tick.now < *drawn_at_)) {
      drawn_at_ = tick.now;
      markers_.publish(
          safety::to_markers(options_, monitor_->kept_free(), verdict, make_header(base_frame_, tick.now)));
    }
  }

  /// The state goes first: motor_control brakes by it.
  void publish(const Verdict& verdict, Time now) {
    nav2_msgs::msg::CollisionMonitorState state;
    state.action_type(static_cast<std::uint8_t>(verdict.action));
    state.polygon_name(std::string(verdict.cause));
    state_.publish(state);
    command_.publish(verdict.allowed, now);
  }

  /// Once when it begins, and when it is over.
  void tell_dark() {
    const double dark = monitor_->dark();
    if ((dark > 0.0) == is_dark_) return;
    is_dark_ = dark > 0.0;
    dark_failsafe_.set(is_dark_);
    diagnostics_->set_value(
        "dark", is_dark_ ? fmt::format("{:.0f} degrees", dark * 180.0 / std::numbers::pi) : "none");
    if (is_dark_)
      log_.warn("what was seen over {:.0f} degrees has vanished: covered, or its light fails; creeping there",
                dark * 180.0 / std::numbers::pi);
  }

  void report(const Verdict& verdict, bool silent) {
    using Level = DiagnosticReporter::Level;
    diagnostics_->set_value("limited", limited_.text());
    for (const auto& [cause, failsafe] : laser_failsafes_) failsafe.set(verdict.cause == cause);
    silent_failsafe_.set(verdict.cause == kCommandSilent && !silent);
    if (silent) return diagnostics_->report(Level::ok, "nobody drives");
    if (verdict.action == Action::do_nothing) return diagnostics_->report(Level::ok, "the way is free");
    const bool is_laser = safety::is_laser_fault(verdict.cause);
    if (is_laser && last_.cause != verdict.cause) {
      const bool unsound = verdict.cause == safety::kLaserInvalid;
      log_.error("{}: stopping{}", verdict.cause, unsound ? ": " + fault_text() : "");
    }
    diagnostics_->report(
        is_laser ? Level::error : Level::warn,
        fmt::format("{}: {}", verdict.action == Action::stop ? "stop" : "limited", verdict.cause));
  }

  std::string fault_text() const {
    const SweepFault fault = monitor_->sweep_fault();
    if (fault != SweepFault::bad_stamp) return to_text(fault);
    const StampAge& stamp = monitor_->stamp();
    const std::string why = fmt::format("its stamp is {}", to_text(stamp.fault));
    const bool is_old = stamp.fault == StampFault::late || stamp.fault == StampFault::overtaken;
    return is_old ? fmt::format("{}: {:.2f} s old", why, stamp.age.to_seconds()) : why;
  }

  safety::CollisionMonitorOptions options_;
  Robot robot_;  ///< its sensors by the frames their messages name
  std::optional<safety::CollisionMonitor> monitor_;
  CurrentFootprint footprint_;
  std::string base_frame_;
  Twist2 wanted_;
  std::optional<Time> wanted_at_;
  Verdict last_;
  bool idle_ = true;
  LimitedShare limited_;
  ScanFrames frames_;
  bool has_driven_ = false;
  bool is_dark_ = false;
  std::map<std::string_view, Failsafe> laser_failsafes_;  ///< by the monitor's cause
  Failsafe dark_failsafe_, silent_failsafe_;
  std::optional<Time> drawn_at_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  VelocityOutput command_;
  Output<nav2_msgs::msg::CollisionMonitorState> state_;
  Output<visualization_msgs::msg::MarkerArray> markers_;
};

}  // namespace

BW_COMPONENT(CollisionMonitorComponent, "collision_monitor")

}  // namespace bw
