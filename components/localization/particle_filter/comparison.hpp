// What a measurement is compared with, the same form for every kind: up to three differences between what
// was measured and what a particle would have read.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "components/localization/measurements.hpp"
#include "components/localization/particle_filter/particle_filter_options.hpp"
#include "components/localization/particle_filter/particle_set.hpp"

namespace bw::localization {

/// A point of the base is where? And which way does the base look? B is the base when the particles are
/// compared, which may be later than the measurement's stamp.
struct Comparison {
  Vector2 point{0.0, 0.0};          ///< in B: the antenna at the stamp
  std::optional<Vector2> position;  ///< of the point, in M
  std::optional<double> range;      ///< from the point to the anchor
  Vector2 anchor{0.0, 0.0};         ///< in M
  std::optional<double> heading;    ///< of B, in M
  int size = 0;                     ///< differences: position (x, y), range, heading in this order
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< their covariance, top left
};

/// X_BS: the base at the stamp in B. `backward`: the base drives backward, for a course.
Comparison compare_at(const PositionFix& fix, const Pose2& X_BS, bool backward);
Comparison compare_at(const PoseReading& reading, const Pose2& X_BS, bool backward);
Comparison compare_at(const RangeReading& reading, const Pose2& X_BS, bool backward);
Comparison compare_at(const HeadingReading& reading, const Pose2& X_BS, bool backward);
Comparison compare_at(const CourseReading& reading, const Pose2& X_BS, bool backward);

/// Differences of all particles as columns; headings wrapped.
struct Differences {
  std::vector<double> column[3];
  int size = 0;
  int heading = -1;  ///< which column is an angle
};

void differences(const Comparison& comparison, const ParticleSet& particles, Differences& result);

/// Normalised innovation squared of the mean difference: r^T (R + spread of the set)^-1 r, chi-square of
/// `size` degrees of freedom for an honest set.
double normalised_innovation(const Comparison& comparison, const ParticleSet& particles,
                             const Differences& d);

/// Adds to log_weight[i] what the law makes of the differences (particle_filter_options.hpp).
void add_log_weights(const Comparison& comparison, const Differences& d, WeightLaw law,
                     std::vector<double>& log_weight);

}  // namespace bw::localization
