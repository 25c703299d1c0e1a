// A pose refined by least squares: points of a scan against the walls of a submap, along their normals.
#pragma once

#include <array>
#include <span>

#include "components/slam/surface_map.hpp"
#include "components/slam/uncertain_pose.hpp"

namespace bw::slam {

/// Of (x, y, theta): takes away what is told along `u`, a unit vector.
inline Eigen::Matrix3d projection_without(const Vector2& u) {
  Eigen::Matrix3d P = Eigen::Matrix3d::Identity();
  P.topLeftCorner<2, 2>() -= u * u.transpose();
  return P;
}

struct Refined {
  Pose2 X;  ///< of what the points are in, in the submap
  /// What the scan alone says of (x, y, theta), in the submap's axes; directions it does not see are left
  /// out.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double inliers = 0.0;  ///< share of the points that end within kInlier of a wall, 0 to 1
  double fit = 0.0;      ///< the same of those with a wall within reach: who overlaps more fits no better
  double rms = 0.0;      ///< of these, along the normals [m]
  /// Unit vector in the submap along which the walls seen do not say where the robot is; zero: none.
  Vector2 unseen{0.0, 0.0};

  /// Along `u`, a unit vector, it says nothing.
  void hide(const Vector2& u) {
    const Eigen::Matrix3d P = projection_without(u);
    information = P * information * P;
    unseen = u;
  }
};

/// [m] from a wall
inline constexpr double kInlier = 0.1;

/// Gauss-Newton with Welsch's weights from `start`, pulled to `prior`, of the same pose; null: none. A
/// direction in which the scan says less than a twentieth of what it says across is not moved by it (Zhang,
/// Kaess, Singh 2016): there the prior decides (theory.md 10.3).
Refined refine(const SurfaceMap& map, std::span<const SurfacePoint> points, const Pose2& start,
               const UncertainPose* prior, int iterations);

/// With what the points do not say of a submap added: 3 cm, 8 mrad, and 3 m along a direction that no wall shows.
UncertainPose with_covariance(const Refined& refined);

}  // namespace bw::slam
