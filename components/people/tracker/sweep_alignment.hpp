// How odometry erred from one sweep to the next, by what stands: wheels of 0.4 % mismatch and some noise
// rotate the world by several milliradians per sweep, which at 5 m reads as a velocity of 0.3 m/s of
// everything.
//
// Points of a sweep against the surface that the sweep before saw in their direction (point to line, Censi,
// ICRA 2008), weighted so that people, who move, hardly count (Tukey), with the odometry as prior.
#pragma once

#include <optional>
#include <vector>

#include "components/people/detection.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::people {

struct AlignmentOptions {
  /// [m] standard deviation of a range
  static constexpr double kRangeNoise = 0.02;
  /// [m] points farther than this from what the sweep before saw say nothing
  static constexpr double kReach = 0.15;
  /// [m] error of the translation between two sweeps by odometry
  static constexpr double kTranslationSigma = 0.004;
  /// [rad] error of the rotation between two sweeps by odometry
  static constexpr double kRotationSigma = 0.015;
  /// of points that must fit, or odometry is believed
  static constexpr double kLeastShare = 0.4;
};

class SweepAlignment {
 public:
  explicit SweepAlignment(const AlignmentOptions& options) : options_(options) {}

  /// X_PO: where this sweep's O lies in the O of the sweep before, as what stands shows it. Identity for the
  /// first sweep, for a sensor that odometry saw at rest, and when too little fits. Remembers the sweep.
  Pose2 align(const DetectionSet& sweep);

  void reset() {
    ranges_.clear();
    X_RO_ = {};
  }

 private:
  struct Surface {
    Vector2 point;
    Vector2 normal;
  };
  struct Equations {
    Eigen::Matrix3d information;
    Eigen::Vector3d pull;
    int compared = 0;  ///< points with a surface
    int fitting = 0;   ///< those near it
  };
  /// Where the sensor of a sweep is.
  struct View {
    Vector2 sensor;
    double angle_min;
  };
  /// (x, y, rotation about the sensor) by which the sweep fits; nothing when too little does.
  std::optional<Eigen::Vector3d> correction_of(const DetectionSet& sweep, const View& view) const;
  Equations compare(const DetectionSet& sweep, const View& view, const Eigen::Vector3d& correction,
                    double reach) const;
  bool surface_towards(const Vector2& p_O, Surface& surface) const;
  Vector2 remembered_point(std::size_t beam) const;
  void remember(const DetectionSet& sweep);

  AlignmentOptions options_;
  Pose2 X_RO_;                ///< O as it is now, in the O of the sweep that is compared with
  std::optional<View> last_;  ///< of the last sweep, in O
  Vector2 sensor_{0.0, 0.0};  ///< of the sweep that is compared with
  double angle_min_ = 0.0;
  double angle_increment_ = 0.0;
  std::vector<float> ranges_;
  std::vector<Vector2> directions_;
  float no_return_ = 0.0F;  ///< beams this long hit nothing
};

}  // namespace bw::people
