// What a robot's log holds, whichever format it came in. Stamps count from the start of the log; lists are
// sorted by stamp. Frames: B base_link, O odom, M map (x east, y north where there are satellites).
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "components/model/local_plane.hpp"
#include "components/model/wheel_step.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct OdometrySample {
  Time time;
  Pose2 X_OB;
  Twist2 twist;  ///< since the sample before
};

/// The part of an inertial unit that a robot on a floor can use.
struct ImuSample {
  Time time;
  std::optional<double> heading;    ///< of the base in the unit's own world, counter-clockwise [rad]
  std::optional<double> turn_rate;  ///< [rad/s]
  double heading_variance = 0.0;    ///< [rad^2]; 0: not declared
};

struct FixSample {
  Time time;
  localization::Geodetic position;
  Eigen::Vector3d variance{0.0, 0.0, 0.0};  ///< east, north, up [m^2]; 0: not declared
};

/// Distance to a radio anchor.
struct RangeSample {
  Time time;
  Vector2 anchor{0.0, 0.0};  ///< in M [m]
  double range = 0.0;        ///< [m]
  double variance = 1.0;     ///< [m^2]
};

/// What the header of a scan says, in the width of its message.
struct ScanGeometry {
  float angle_min = 0.0F;        ///< of the first beam, in the scanner's frame [rad]
  float angle_max = 0.0F;        ///< of the last beam [rad]
  float angle_increment = 0.0F;  ///< [rad]
  float time_increment = 0.0F;   ///< from beam to beam [s]
  float period = 0.0F;           ///< from sweep to sweep [s]
  float range_min = 0.0F;        ///< [m]
  float range_max = 0.0F;        ///< [m]
};

struct ScanSample {
  Time time;
  std::string frame;  ///< of the scanner; a drive may have several
  ScanGeometry geometry;
  std::vector<float> ranges;  ///< [m]; +inf: no return, NaN: not measured
  std::vector<float> intensities;
};

/// Where one frame sits on another, for good.
struct FrameMount {
  std::string parent;
  std::string child;
  Eigen::Vector3d translation{0.0, 0.0, 0.0};    ///< [m]
  Eigen::Vector4d rotation{0.0, 0.0, 0.0, 1.0};  ///< quaternion x, y, z, w
};

/// Where the robot was by an independent measurement.
struct ReferencePose {
  Time time;
  Vector2 position{0.0, 0.0};     ///< in M [m]
  std::optional<double> heading;  ///< [rad]
};

struct RecordedDrive {
  std::vector<OdometrySample> odometry;
  std::vector<ImuSample> imu;
  std::vector<FixSample> fixes;
  std::vector<RangeSample> ranges;
  std::vector<ScanSample> scans;
  std::vector<ReferencePose> truth;
  std::vector<FrameMount> mounts;
  std::string imu_frame = "imu";
  std::string gps_frame = "gps";
  localization::Geodetic datum;   ///< origin of M; without meaning where there are no fixes
  double wheel_separation = 0.0;  ///< [m]
  double wheel_variance = 0.0;    ///< declared for the speed of a wheel [m^2/s^2]; 0: not declared
};

/// Makes stamps count from `start`, or from the first of them, and returns what they count from.
Time count_from(std::optional<Time> start, RecordedDrive& drive);

/// Travel of the wheels between two samples of the drive, in the time of the log: with the covariance that
/// the log declares, else by variance_per_metre (wheel_step.hpp).
WheelStep step_between(const RecordedDrive& drive, const OdometrySample& from, const OdometrySample& to,
                       double variance_per_metre);

/// Continues an odometry along the arc of `twist` until `time`.
OdometrySample advance(const OdometrySample& sample, const Twist2& twist, Time time);

/// X_OB at a stamp, by one body velocity between two samples; nothing outside of them or in a gap longer than
/// `longest`. In order of time.
std::optional<Pose2> odometry_at(const std::vector<OdometrySample>& odometry, Time time, Duration longest);

/// Reference at a stamp by interpolation; nothing outside of the reference or in a gap longer than `longest`.
std::optional<ReferencePose> reference_at(const RecordedDrive& drive, Time time, Duration longest);

/// Mean twist between two references; zero where one has no heading or they are of one moment.
Twist2 twist_between(const ReferencePose& from, const ReferencePose& to);

/// One entry of a drive, which must outlive it.
using RecordedEvent = std::variant<const OdometrySample*, const ImuSample*, const FixSample*,
                                   const RangeSample*, const ScanSample*, const ReferencePose*>;

inline Time stamp(const RecordedEvent& event) {
  return std::visit([](const auto* sample) { return sample->time; }, event);
}

/// All entries by stamp; those of one stamp in the order of the alternatives.
std::vector<RecordedEvent> in_time_order(const RecordedDrive& drive);

/// Those from second `start` of the log to second `end`, if that is not 0.
std::vector<RecordedEvent> events_between(const RecordedDrive& drive, double start, double end);

}  // namespace bw
