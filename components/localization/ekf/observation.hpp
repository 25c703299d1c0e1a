// What a measurement should read, and how it depends on the state: the innovations of the EKF. A measurement
// between two wheel steps is compared with the pose extrapolated to its stamp; the state stays where it is.
#pragma once

#include "components/localization/ekf/correction.hpp"
#include "components/localization/ekf/ekf_state.hpp"
#include "components/localization/ekf/motion.hpp"

namespace bw::localization {

Innovation<kStates, 2> observe(const PositionFix& fix, const Extrapolated& at);
Innovation<kStates, 3> observe(const PoseReading& reading, const Extrapolated& at);
Innovation<kStates, 1> observe(const RangeReading& reading, const Extrapolated& at);
/// Reads theta + heading offset.
Innovation<kStates, 1> observe(const HeadingReading& reading, const Extrapolated& at, double heading_offset);
/// Reads theta, or theta + pi while driving backward.
Innovation<kStates, 1> observe(const CourseReading& reading, const Extrapolated& at, bool backward);

}  // namespace bw::localization
