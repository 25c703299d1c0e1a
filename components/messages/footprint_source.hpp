// Where the robot's footprint is changed while it runs, as in Nav2's costmaps: parameters `footprint`,
// `robot_radius`, `footprint_padding` and the topic `footprint`. What is accepted is told to every component
// on `robot_footprint`, latched.
// For adaptors only.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include <geometry_msgs/msg/polygon.hpp>
#include <geometry_msgs/msg/polygon_stamped.hpp>

#include "components/messages/current_footprint.hpp"
#include "components/model/footprint_options.hpp"

namespace bw {

/// Lives in the component whose setup it is given; that component hears of a change as all others do.
class FootprintSource {
 public:
  void offer(Setup& setup, const Robot& robot, const FootprintOptions& options,
             std::function<void(const Footprint&)> on_change) {
    robot_ = robot.outline();
    options_ = options;
    has_told_ = false;
    may_change_ = CurrentFootprint::may_change(setup);
    if (!may_change_ && options != FootprintOptions{}) throw std::runtime_error(kFixed);
    base_frame_ = setup.frame("base_link");
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    told_ = setup.output<geometry_msgs::msg::PolygonStamped>("robot_footprint", Qos::latched());
    current_.listen(setup, robot, std::move(on_change));
    if (!may_change_) return;
    setup.input<geometry_msgs::msg::Polygon>(
        "footprint", Qos::standard(), [this](const auto& message, const Tick& tick) { take(message, tick); },
        Need::optional);
  }
  void activate(const Tick& tick) {
    if (options_ != FootprintOptions{} && !has_told_) tell(footprint_of(options_, robot_), tick);
  }
  /// Throws std::runtime_error where it may not change.
  void set_options(const FootprintOptions& options, const Tick& tick) {
    if (options == options_) return;
    if (!may_change_) throw std::runtime_error(kFixed);
    options_ = options;
    tell(footprint_of(options_, robot_), tick);
  }
  const Footprint& now() const { return current_.now(); }

 private:
  static constexpr const char* kFixed =
      "in lock-step the footprint is that of section robot, unless --accept-inputs lets it change";

  void take(const geometry_msgs::msg::Polygon& message, const Tick& tick) {
    FootprintResult told = to_footprint(message);
    diagnostics_->set_value("footprint", told.fault.empty() ? "as told" : "refused: it " + told.fault);
    if (told.fault.empty()) return tell(padded(told.footprint, options_.footprint_padding), tick);
    log_.error("a footprint on topic footprint is refused, the one before stays: it {}", told.fault);
  }
  void tell(const Footprint& footprint, const Tick& tick) {
    geometry_msgs::msg::PolygonStamped message;
    message.header(make_header(base_frame_, tick.now));
    message.polygon(to_polygon(footprint));
    told_.publish(message);
    has_told_ = true;
    log_.info(
        "the robot's footprint is {} from now on",
        footprint.is_polygon() ? to_text(footprint) : "a disc of " + std::to_string(footprint.radius) + " m");
  }

  Footprint robot_;
  FootprintOptions options_;
  bool may_change_ = false;
  bool has_told_ = false;
  CurrentFootprint current_;
  std::string base_frame_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  Output<geometry_msgs::msg::PolygonStamped> told_;
};

}  // namespace bw
