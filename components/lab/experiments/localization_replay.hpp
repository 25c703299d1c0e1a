// A recorded drive run through a filter in process, compared with known positions along the path.
#pragma once

#include <optional>
#include <vector>

#include "components/localization/localizer.hpp"
#include "components/recordings/recorded_drive.hpp"

namespace bw {

/// What the filter hears, and what it is told of sensors whose log declares nothing. The defaults are those
/// of the localization component, for every log.
struct ReplaySensors {
  bool gyro = true;
  bool compass = true;
  bool receiver = true;
  bool ranges = true;
  double wheel_noise = 5e-4;    ///< k of model/README.md 2.2 [m]
  double gyro_noise = 0.01;     ///< [rad/s]
  double compass_noise = 0.05;  ///< [rad]
  /// An inertial unit whose zero points anywhere: its heading is of use only once the pose is known.
  bool compass_after_start = false;
};

/// A position the robot was at, unknown to the filter.
struct Checkpoint {
  Time time;
  Vector2 position{0.0, 0.0};  ///< in M [m]
};

struct ReplayPoint {
  Time time;
  Vector2 position{0.0, 0.0};
  double error = 0.0;  ///< distance to the checkpoint [m]
};

struct ReplayErrors {
  double mean = 0.0;
  double rms = 0.0;
  double largest = 0.0;
  std::size_t count = 0;
};

struct ReplayResult {
  std::vector<ReplayPoint> points;  ///< one for each checkpoint after the first pose
  std::optional<Time> first_pose;
  localization::Estimate last;
};

ReplayErrors errors_of(const std::vector<ReplayPoint>& points);

/// Feeds the filter, in order of stamps and each at its own, until `end`; checkpoints must be sorted. A
/// checkpoint is compared when all that was measured up to its stamp has been heard.
ReplayResult replay(const RecordedDrive& drive, const ReplaySensors& sensors,
                    const std::vector<Checkpoint>& checkpoints, localization::Localizer& filter);

/// The checkpoints a log gives by itself.
std::vector<Checkpoint> reference_checkpoints(const RecordedDrive& drive);
std::vector<Checkpoint> fix_checkpoints(const std::vector<FixSample>& fixes,
                                        const localization::Geodetic& datum);

}  // namespace bw
