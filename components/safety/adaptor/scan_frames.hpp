// Whether the robot file says where the laser of a scan sits. A robot file that lists sensors must list this
// one: an obstacle would be looked for where it is not. One that lists none has its laser at base_link.
// Transforms do not count: they come and go, and the collision monitor hangs on this.
#pragma once

#include <string>
#include <utility>

#include "components/model/robot.hpp"
#include "runtime/complaint.hpp"
#include "runtime/logger.hpp"

namespace bw {

class ScanFrames {
 public:
  ScanFrames() = default;
  /// The frames of `robot` are those that messages name.
  ScanFrames(Robot robot, std::string base_frame, Logger log)
      : robot_(std::move(robot)), base_frame_(std::move(base_frame)), log_(std::move(log)) {}

  /// Says once of each frame that it is not.
  bool is_placed(const std::string& frame) {
    const bool is_known = frame.empty() || frame == base_frame_ || robot_.has_mount_of(frame);
    const bool lists_none = robot_.sensors.empty();
    if (!unplaced_.is_news(is_known ? "" : frame) || is_known) return is_known || lists_none;
    if (lists_none)
      log_.warn("robot.sensors does not say where '{}' sits: taken as at '{}'", frame, base_frame_);
    else
      log_.error(
          "scans come from frame '{}', which robot.sensors does not list: refused; add {{frame: {}, x: ..., y: ..., theta: ...}} there, "
          "or have the laser's driver name a frame of the list",
          frame, frame);
    return lists_none;
  }

 private:
  Robot robot_;
  std::string base_frame_;
  Logger log_;
  Complaint unplaced_;
};

}  // namespace bw
