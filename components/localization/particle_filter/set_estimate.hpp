// Mean and covariance of a set, or of its heaviest group.
#pragma once

#include <Eigen/Core>

#include "components/localization/particle_filter/particle_set.hpp"
#include "components/localization/particle_filter/pose_histogram.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::localization {

struct SetEstimate {
  Pose2 X_MB;  ///< weighted mean; heading: direction of the mean of (cos, sin)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, theta), headings about their mean
  double share = 1.0;                                    ///< of the weight that it is made of
};

SetEstimate estimate_of(const ParticleSet& particles);

/// Of the heaviest group of particles where the set is wider than one (as AMCL answers).
SetEstimate estimate_of_heaviest(const ParticleSet& particles, PoseHistogram& histogram);

}  // namespace bw::localization
