// Moves every particle by the same motion and a noise of its own: X_i <- X_i * (X_BB + L n), n ~ N(0, I),
// L L^T the motion's covariance.
#pragma once

#include <vector>

#include "components/localization/particle_filter/lane_random.hpp"
#include "components/localization/particle_filter/odometry_track.hpp"
#include "components/localization/particle_filter/particle_set.hpp"

namespace bw::localization {

/// Lower L with L L^T = C; what rounding made negative counts as zero.
Eigen::Matrix3d square_root(const Eigen::Matrix3d& C);

class ParticleMotion {
 public:
  explicit ParticleMotion(std::uint64_t seed) : random_(seed) {}

  void move(ParticleSet& particles, const UncertainMotion& motion);
  /// Draws from N(mean, covariance) into particles [first, first + count).
  void scatter(ParticleSet& particles, std::size_t first, std::size_t count, const Pose2& mean,
               const Eigen::Matrix3d& covariance);

 private:
  LaneRandom random_;
  std::vector<float> normals_;
};

}  // namespace bw::localization
