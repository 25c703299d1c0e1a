// Adaptor of the twist multiplexer: velocities that several want in, one out, on arrival.
#include <optional>
#include <string>
#include <utility>

#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <fmt/format.h>
#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/empty.hpp>

#include "components/messages/geometry.hpp"
#include "components/twist_mux/goal_in_hand.hpp"
#include "components/twist_mux/twist_mux.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::NavigationStatus;
using geometry_msgs::msg::Twist;
using geometry_msgs::msg::TwistStamped;

constexpr const char* kInterrupted = "interrupted by a hand: until release_stop, or another goal";
constexpr Duration kCheckPeriod = Duration::milliseconds(10);

class TwistMuxComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<TwistMuxOptions>();
    mux_.emplace(options_);
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    out_ = setup.command<Twist>("cmd_vel_mux");
    for (std::size_t i = 0; i < options_.sources.size(); ++i) {
      const TwistSourceOptions& source = options_.sources[i];
      const Need need = source.optional ? Need::optional : Need::required;
      if (source.stamped) {
        setup.input<TwistStamped>(
            source.topic, Qos::command(),
            [this, i](const auto& message, const Tick& tick) {
              on_command(i, from_twist(message.twist()), from_stamp(message.header().stamp()), tick);
            },
            need);
      } else {
        setup.input<Twist>(
            source.topic, Qos::command(),
            [this, i](const auto& message, const Tick& tick) {
              on_command(i, from_twist(message), std::nullopt, tick);
            },
            need);
      }
    }
    interrupted_ = setup.failsafe({.name = "hand",
                                   .condition = "a hand has driven while a goal was in hand",
                                   .action = FailsafeAction::stop_latched,
                                   .recovery = "by release_stop, or another goal"});
    override_ = setup.output<std_msgs::msg::Bool>("manual_override", Qos::latched());
    setup.input<NavigationStatus>(
        "navigation_status", Qos::latched(),
        [this](const auto& status, const Tick&) {
          if (goal_.see(status.goal_id(), static_cast<GoalStatus>(status.status()),
                        status.number_of_goals_remaining()))
            mux_->release();
          mux_->set_goal(goal_.is_in_hand());
          tell_override();
        },
        Need::optional);
    setup.input<std_msgs::msg::Empty>(
        "stop_released", Qos::standard(),
        [this](const auto&, const Tick&) {
          mux_->release();
          tell_override(true);
        },
        Need::optional);
    setup.every(kCheckPeriod, "check", [this](const Tick& tick) { check(tick); });
  }

  void deactivate(const Tick&) override { out_.publish({}); }

 private:
  void on_command(std::size_t i, const Twist2& twist, std::optional<Time> stamp, const Tick& tick) {
    publish(mux_->command(tick.now, i, twist, stamp, {tick.from.writer, tick.from.is_own_clock}), tick);
    tell_override();
  }

  /// News, and after each release all the same: who heard of an interruption before this instance was still
  /// waits.
  void tell_override(bool is_asked = false) {
    const bool is_news = mux_->is_interrupted() != is_interrupted_;
    if (!is_news && !is_asked) return;
    is_interrupted_ = mux_->is_interrupted();
    interrupted_.set(is_interrupted_);
    std_msgs::msg::Bool message;
    message.data(is_interrupted_);
    override_.publish(message);
    if (!is_news) return;
    log_.info("{}", is_interrupted_ ? kInterrupted : "who was interrupted by a hand is heard again");
    tell(active_);
  }

  void check(const Tick& tick) {
    const auto stop = mux_->check(tick.now);
    publish(stop, tick);
    if (stop && drove_) log_.info("{} has fallen silent: stopping", options_.sources[*drove_].topic);
    report(tick.now);
  }

  void publish(const std::optional<Twist2>& twist, const Tick& tick) {
    if (twist) out_.publish(to_twist_message(tick.health == Health::stop ? Twist2{} : *twist));
  }

  /// For the log it is news when somebody else drives than before.
  void report(Time now) {
    const auto active = mux_->active(now);
    std::uint64_t refused = 0, steps = 0;
    for (std::size_t i = 0; i < options_.sources.size(); ++i) {
      const TwistMux::Count& count = mux_->count(i);
      refused += count.not_finite + count.stale;
      steps += count.steps;
    }
    if (steps != std::exchange(steps_, steps))
      log_.warn("the clock that stamps somebody's commands was set, or all before were late");
    if (active == active_ && refused == refused_) return;
    if (refused > 0 && refused_ == 0) log_.warn("commands are refused: /diagnostics says whose and why");
    if (active && drove_ && active != drove_) log_.info("{} drives", options_.sources[*active].topic);
    if (active) drove_ = active;
    active_ = active;
    refused_ = refused;
    tell(active);
  }

  void tell(std::optional<std::size_t> active) {
    using Level = DiagnosticReporter::Level;
    for (std::size_t i = 0; i < options_.sources.size(); ++i) {
      const TwistMux::Count& count = mux_->count(i);
      if (count.not_finite + count.stale == 0) continue;
      std::string text =
          fmt::format("refused: {} not finite, {} for their stamps", count.not_finite, count.stale);
      if (count.stale > 0)
        text += fmt::format(", the last: {}, {:.2f} s old", to_text(count.last_stale.fault),
                            count.last_stale.age.to_seconds());
      diagnostics_->set_value(options_.sources[i].topic, text);
    }
    std::string who = active ? options_.sources[*active].topic + " drives" : "nobody drives";
    if (mux_->is_interrupted()) who += std::string("; ") + kInterrupted;
    diagnostics_->report(refused_ == 0 ? Level::ok : Level::warn,
                         refused_ == 0 ? who : fmt::format("{}; {} commands refused", who, refused_));
  }

  TwistMuxOptions options_;
  std::optional<TwistMux> mux_;
  GoalInHand goal_;
  Failsafe interrupted_;
  bool is_interrupted_ = false;  ///< as told last
  Output<std_msgs::msg::Bool> override_;
  std::optional<std::size_t> active_;  ///< as told last
  std::optional<std::size_t> drove_;
  std::uint64_t refused_ = 0, steps_ = 0;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  Output<Twist> out_;
};

}  // namespace

BW_COMPONENT(TwistMuxComponent, "twist_mux")

}  // namespace bw
