// A calibration as lines of a robot file, and put into one: what else stands there, comments too, stays as it
// is.
#pragma once

#include <string>

#include "components/robot_base/calibration/measured_motion.hpp"

namespace bw {

/// Three lines of YAML: wheel_radius, wheel_radius_ratio, wheel_separation.
std::string geometry_lines(const WheelGeometry& geometry);

/// The text of a robot file with these values. Throws std::runtime_error where it has no line of
/// `wheel_radius` or `wheel_separation` of its own at the left margin.
std::string with_geometry(const std::string& text, const WheelGeometry& geometry);

}  // namespace bw
