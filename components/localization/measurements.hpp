// What sensors tell a localization: one vocabulary for every filter. Frames: B base_link, M map (x east, y
// north where satellites are used). Stamps are of the measurement, not of its arrival.
#pragma once

#include <variant>

#include <Eigen/Core>

#include "components/model/wheel_step.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::localization {

/// Sources are numbered from 0; one source gives one kind of measurement. A filter is told at its making how
/// many there are; this many have room in one that was told nothing.
constexpr int kUsualSources = 8;

/// Position of an antenna, e.g. a satellite fix taken to the local plane (local_plane.hpp).
struct PositionFix {
  Time time;
  int source = 0;
  Vector2 position{0.0, 0.0};                                ///< in M [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< [m^2]
  Vector2 antenna{0.0, 0.0};                                 ///< in B [m]
};

/// Heading of the base from a compass or an IMU's orientation, counter-clockwise from x of M.
struct HeadingReading {
  Time time;
  int source = 0;
  double heading = 0.0;   ///< [rad]
  double variance = 1.0;  ///< [rad^2]
};

/// Turn rate about z.
struct GyroReading {
  Time time;
  int source = 0;
  double rate = 0.0;      ///< [rad/s]
  double variance = 1.0;  ///< [rad^2/s^2], of one reading
};

/// Direction of motion over ground: the heading of a base that drives forward, its opposite in reverse.
struct CourseReading {
  Time time;
  int source = 0;
  double course = 0.0;    ///< in M [rad]
  double variance = 1.0;  ///< [rad^2]
};

/// Distance to a known position, e.g. a radio anchor.
struct RangeReading {
  Time time;
  int source = 0;
  double range = 0.0;         ///< from the antenna [m]
  double variance = 1.0;      ///< [m^2]
  Vector2 anchor{0.0, 0.0};   ///< in M [m]
  Vector2 antenna{0.0, 0.0};  ///< in B [m]
};

/// Pose from anything that knows all three, e.g. scan matching or markers.
struct PoseReading {
  Time time;
  int source = 0;
  Pose2 X_MB;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of (x, y, theta)
};

/// The order of the alternatives is the order in which measurements of one stamp are used: the gyro before
/// the wheel step that it corrects, motion before what is compared with its end.
using Measurement = std::variant<GyroReading, WheelStep, PoseReading, PositionFix, HeadingReading,
                                 CourseReading, RangeReading>;

inline Time stamp(const Measurement& m) {
  return std::visit([](const auto& value) { return value.time; }, m);
}
inline int source(const Measurement& m) {
  return std::visit([](const auto& value) { return value.source; }, m);
}

}  // namespace bw::localization
