// A source that the gate rejects for long: is the source wrong, or the estimate?
//
// A run counts the rejections of one source that agree with each other: positions no further apart than the
// wheels travelled (plus noise), headings that rotated as the wheels did. Three in a row that do not agree
// begin a new run; any measurement accepted ends it. The source takes the estimate over when its run
//   - has lasted gate.reacquire_after and has gate.reacquire_count members, and
//   - no other source that gives the same was accepted during the run (for a heading: also no positions while
//     the robot drove gate.heading_support, since they show the heading too).
#pragma once

#include <optional>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"

namespace bw::localization {

/// A rejected measurement: what it says of position, heading or both, with the odometry at its stamp.
struct Rejection {
  Time time;
  int source = 0;
  std::optional<Vector2> position;  ///< of the antenna [m]
  double position_variance = 0.0;   ///< the larger axis
  Vector2 antenna{0.0, 0.0};
  std::optional<double> heading;
  double heading_variance = 0.0;
};

/// Adds it to its source's run; true when the source may now take the estimate over.
bool note_rejection(EkfState& state, const Rejection& rejection, const GateOptions& options);

/// Puts the estimate where the rejected run says, and ends the run.
///  - Position and heading: both, with the reading's covariance.
///  - Position only: the reading's position. The heading is that of the path by wheels rotated and shifted
///    onto the run's positions, if they show it well (0.25 rad) and either no other heading was accepted
///    meanwhile or it disagrees with the estimate by the gate; else the heading stays.
///  - Heading only: the heading; the offset state stays.
void take_over(EkfState& state, const Rejection& rejection, const Eigen::Matrix3d& covariance,
               const GateOptions& options);

}  // namespace bw::localization
