#include "components/slam/refinement.hpp"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace bw::slam {
namespace {

constexpr double kNoise = 0.03;            // [m] of a pose in a submap, beyond what the scan says
constexpr double kTurnNoise = 0.008;       // [rad]
constexpr double kFree = 3.0;              // [m] along a direction that nothing shows
constexpr double kPointNoise = 0.025;      // [m] of a point along a normal: the scanner's and the map's
constexpr double kEffectivePoints = 15.0;  // the errors of neighbouring beams are alike
constexpr double kUsualRms = 0.02;  // [m] where points lie farther from the walls, clutter is taken for walls
constexpr double kUnseen = 0.05;    // of the information across
constexpr double kClutter = 0.05;   // weight of points off straight walls: they hold the pose where it was
constexpr double kWelsch = 0.08;    // [m] distance at which a point counts by 1 / e
constexpr double kConverged = 1e-5;

struct System {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();  // about the pose's own position
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  int in_reach = 0;
  int inliers = 0;
  double squares = 0.0;
  double weights = 0.0;
};

// One row: a displacement r [m] of point p (relative to the pose's position) along the unit vector n.
void add_row(const Vector2& n, double lever, double r, double weight, System& system) {
  const Eigen::Vector3d J{n.x(), n.y(), lever};
  system.H.noalias() += weight * J * J.transpose();
  system.b.noalias() -= weight * r * J;
}

System linearised(const SurfaceMap& map, std::span<const SurfacePoint> points, const Pose2& X) {
  System system;
  const double c = std::cos(X.theta);
  const double s = std::sin(X.theta);
  for (const SurfacePoint& point : points) {
    const double ax = c * static_cast<double>(point.x) - s * static_cast<double>(point.y);
    const double ay = s * static_cast<double>(point.x) + c * static_cast<double>(point.y);
    const Surface* surface = map.nearest(X.x + ax, X.y + ay);
    if (surface == nullptr) continue;
    ++system.in_reach;
    const Vector2 d{X.x + ax - static_cast<double>(surface->x), X.y + ay - static_cast<double>(surface->y)};
    const double straight =
        std::hypot(static_cast<double>(surface->normal_cos2), static_cast<double>(surface->normal_sin2));
    const double squared = d.squaredNorm();
    if (straight > 0.5) {
      const double angle = 0.5 * std::atan2(static_cast<double>(surface->normal_sin2),
                                            static_cast<double>(surface->normal_cos2));
      const Vector2 n = direction(angle);
      const double r = n.dot(d);
      const double weight = std::exp(-r * r / (2.0 * kWelsch * kWelsch));
      add_row(n, cross({ax, ay}, n), r, weight, system);
      if (std::abs(r) < kInlier) {
        ++system.inliers;
        system.squares += r * r;
        system.weights += 1.0;
      }
    } else {
      // Corners and clutter: both directions, as unsure as a cell is wide.
      const double weight = kClutter * std::exp(-squared / (2.0 * kWelsch * kWelsch));
      add_row({1.0, 0.0}, -ay, d.x(), weight, system);
      add_row({0.0, 1.0}, ax, d.y(), weight, system);
      if (squared < kInlier * kInlier) {
        ++system.inliers;
        system.squares += 0.5 * squared;
        system.weights += 1.0;
      }
    }
  }
  return system;
}

}  // namespace

Refined refine(const SurfaceMap& map, std::span<const SurfacePoint> points, const Pose2& start,
               const UncertainPose* prior, int iterations) {
  Refined result;
  result.X = start;
  if (points.empty()) return result;
  Eigen::Matrix3d prior_information = Eigen::Matrix3d::Zero();
  if (prior != nullptr) {
    const Eigen::Matrix3d covariance = prior->covariance + 1e-12 * Eigen::Matrix3d::Identity();
    prior_information = covariance.inverse();
  }
  for (int iteration = 0; iteration <= iterations; ++iteration) {
    const System system = linearised(map, points, result.X);
    result.inliers = static_cast<double>(system.inliers) / static_cast<double>(points.size());
    result.fit = system.in_reach > 0 ? static_cast<double>(system.inliers) / system.in_reach : 0.0;
    result.rms = system.weights > 0.0 ? std::sqrt(system.squares / system.weights) : 0.0;
    const double certainty =
        result.inliers * std::min(1.0, kUsualRms / std::max(result.rms, 1e-3)) / kPointNoise;
    const double scale =
        certainty * certainty * std::min(1.0, kEffectivePoints / static_cast<double>(points.size()));
    Eigen::Matrix3d H = scale * system.H;
    Eigen::Vector3d b = scale * system.b;
    // Position with the heading free: what is left of it along its weakest direction?
    result.unseen = Vector2::Zero();
    const double turning = H(2, 2) + prior_information(2, 2);
    Eigen::Matrix2d position = H.topLeftCorner<2, 2>();
    if (turning > 0.0) position -= H.block<2, 1>(0, 2) * H.block<1, 2>(2, 0) / turning;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(position);
    if (eigen.eigenvalues()(0) < kUnseen * eigen.eigenvalues()(1)) {
      result.unseen = eigen.eigenvectors().col(0);
      const Eigen::Matrix3d P = projection_without(result.unseen);
      H = P * H * P;
      b = P * b;
    }
    result.information = H;
    if (iteration == iterations) break;
    Eigen::Matrix3d A = H + prior_information;
    if (prior != nullptr) b -= prior_information * difference(result.X, prior->X);
    A += 1e-6 * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d step = A.ldlt().solve(b);
    if (!step.allFinite()) break;
    result.X = {result.X.x + step.x(), result.X.y + step.y(), wrap_angle(result.X.theta + step.z())};
    if (step.head<2>().norm() < kConverged && std::abs(step.z()) < kConverged) iterations = iteration + 1;
  }
  return result;
}

UncertainPose with_covariance(const Refined& refined) {
  const Eigen::Matrix3d weak =
      Eigen::Vector3d{1.0 / (kFree * kFree), 1.0 / (kFree * kFree), 1.0}.asDiagonal();
  UncertainPose X{refined.X, (refined.information + weak).inverse()};
  X.covariance.diagonal() += Eigen::Vector3d{kNoise * kNoise, kNoise * kNoise, kTurnNoise * kTurnNoise};
  return X;
}

}  // namespace bw::slam
