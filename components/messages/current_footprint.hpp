// The robot's footprint as of now: that of section `robot` until another is told on topic `robot_footprint`
// (FootprintSource tells it). For adaptors only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <geometry_msgs/msg/polygon_stamped.hpp>

#include "components/messages/footprint.hpp"
#include "components/model/robot.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Lives in the component whose setup it is given.
class CurrentFootprint {
 public:
  /// Nothing changes it in a run in lock-step that takes nothing from outside: there nobody listens.
  static bool may_change(const Setup& setup) { return !setup.is_lockstep() || setup.accepts_inputs(); }

  /// `on_change` is called with each that is new; `below` is the name of one of several robots, with its
  /// slash.
  void listen(Setup& setup, const Robot& robot, std::function<void(const Footprint&)> on_change = {},
              const std::string& below = "") {
    footprint_ = robot.outline();
    told_.reset();
    on_change_ = std::move(on_change);
    base_frame_ = setup.frame(below + "base_link");
    log_ = setup.log();
    if (!may_change(setup)) return;
    setup.input<geometry_msgs::msg::PolygonStamped>(
        below + "robot_footprint", Qos::latched(),
        [this](const auto& message, const Tick& tick) { take(message, tick.now); }, Need::optional);
  }
  const Footprint& now() const { return footprint_; }

 private:
  /// Of several who tell it the last counts, in whatever order they are heard; all anew where the clock went
  /// back.
  void take(const geometry_msgs::msg::PolygonStamped& message, Time now) {
    const Time stamp = from_stamp(message.header().stamp());
    if (told_ && stamp < *told_ && *told_ <= now) return;
    FootprintResult told = to_polygon_or_disc(message.polygon());
    if (message.header().frame_id() != base_frame_) told.fault = "must be in frame " + base_frame_;
    if (fault_.is_news(told.fault) && fault_) log_.error("a footprint is not used: it {}", told.fault);
    if (fault_) return;
    told_ = stamp;
    footprint_ = std::move(told.footprint);
    if (on_change_) on_change_(footprint_);
  }

  Footprint footprint_;
  std::string base_frame_;
  std::optional<Time> told_;
  std::function<void(const Footprint&)> on_change_;
  Complaint fault_;
  Logger log_;
};

}  // namespace bw
