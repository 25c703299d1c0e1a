#include "components/people/detector/features.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace bw::people {

const std::array<const char*, kFeatures> kFeatureNames = {"points",
                                                          "distance",
                                                          "width",
                                                          "across",
                                                          "depth",
                                                          "spread",
                                                          "median_deviation",
                                                          "linearity",
                                                          "circle_radius",
                                                          "circle_residual",
                                                          "leg_radius",
                                                          "leg_residual",
                                                          "boundary_length",
                                                          "boundary_regularity",
                                                          "curvature",
                                                          "inscribed_angle",
                                                          "inscribed_spread",
                                                          "bulge",
                                                          "right_jump",
                                                          "left_jump",
                                                          "least_jump",
                                                          "spacing",
                                                          "nearest",
                                                          "second_nearest",
                                                          "nearest_width",
                                                          "about"};

namespace {

struct Moments {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;

  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double mean() const { return count > 0 ? sum / count : 0.0; }
  double deviation() const {
    return count > 0 ? std::sqrt(std::max(0.0, squares / count - mean() * mean())) : 0.0;
  }
};

float bounded(double value, double limit) {
  return static_cast<float>(std::isfinite(value) ? std::clamp(value, -limit, limit) : limit);
}

/// The points' extents, their scatter, and the line through them.
void add_extents(const Outline& outline, Features& f) {
  const auto& points = outline.points;
  Vector2 low = points.front();
  Vector2 high = points.front();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Vector2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    scatter += p * p.transpose();  // the mean is the origin
  }
  const double n = static_cast<double>(points.size());
  const Vector2& middle = points[points.size() / 2];
  double deviation = 0.0;
  for (const Vector2& p : points) deviation += (p - middle).norm();
  const double half_trace = scatter.trace() / 2.0;
  const double root = std::sqrt(std::max(0.0, half_trace * half_trace - scatter.determinant()));
  f[Feature::points] = static_cast<float>(n);
  f[Feature::distance] = static_cast<float>(outline.distance);
  f[Feature::width] = static_cast<float>(outline.width());
  f[Feature::across] = static_cast<float>(high.y() - low.y());
  f[Feature::depth] = static_cast<float>(high.x() - low.x());
  f[Feature::spread] = static_cast<float>(std::sqrt(scatter.trace() / n));
  f[Feature::median_deviation] = static_cast<float>(deviation / n);
  f[Feature::linearity] = static_cast<float>(std::sqrt(std::max(0.0, half_trace - root) / n));
}

/// Algebraic circle through all points (Kasa 1976): |p|^2 = 2 a x + 2 b y + c.
void add_circle(const Outline& outline, Features& f) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const Vector2& p : outline.points) {
    const Eigen::Vector3d row(2.0 * p.x(), 2.0 * p.y(), 1.0);
    A += row * row.transpose();
    b += p.squaredNorm() * row;
  }
  double radius = 1.0;
  double residual = 0.0;
  const double scale = A.trace();
  if (outline.points.size() >= 3 && std::abs(A.determinant()) > 1e-9 * scale * scale * scale) {
    const Eigen::Vector3d x = A.inverse() * b;
    radius = std::sqrt(std::max(0.0, x[2] + x.head<2>().squaredNorm()));
    for (const Vector2& p : outline.points) residual += std::pow((p - x.head<2>()).norm() - radius, 2.0);
    residual = std::sqrt(residual / static_cast<double>(outline.points.size()));
  }
  f[Feature::circle_radius] = bounded(radius, 1.0);
  f[Feature::circle_residual] = bounded(residual, 1.0);
}

void add_boundary(const Outline& outline, Features& f) {
  const auto& points = outline.points;
  Moments steps;
  Moments curvature;
  Moments inscribed;
  for (std::size_t i = 1; i < points.size(); ++i) steps.add((points[i] - points[i - 1]).norm());
  // Neighbours a quarter of the outline away: nearer ones would measure the noise of ranges.
  const std::size_t arm = std::max<std::size_t>(1, points.size() / 4);
  for (std::size_t i = arm; i + arm < points.size(); ++i) {
    const Vector2 a = points[i - arm] - points[i];
    const Vector2 b = points[i + arm] - points[i];
    const double sides = a.norm() * b.norm() * (b - a).norm();
    // From right to left a convex thing turns right as the scanner sees it.
    if (sides > 1e-9) curvature.add(-2.0 * cross(a, b) / sides);
  }
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vector2 a = points.front() - points[i];
    const Vector2 b = points.back() - points[i];
    inscribed.add(std::abs(std::atan2(cross(a, b), a.dot(b))));
  }
  f[Feature::boundary_length] = static_cast<float>(steps.sum);
  f[Feature::boundary_regularity] = static_cast<float>(steps.deviation());
  f[Feature::curvature] = bounded(curvature.mean(), 100.0);
  f[Feature::inscribed_angle] = static_cast<float>(inscribed.mean());
  f[Feature::inscribed_spread] = static_cast<float>(inscribed.deviation());
  const std::size_t third = points.size() / 3;
  Moments middle;
  for (std::size_t i = third; i < points.size() - third; ++i) middle.add(points[i].x());
  const double chord = (points.front().x() + points.back().x()) / 2.0;
  f[Feature::bulge] = bounded((chord - middle.mean()) / std::max(outline.width(), 0.01), 10.0);
}

}  // namespace

Features features_of(const Outline& outline, const DiscFit& leg, const Neighbours& neighbours) {
  constexpr double kFarJump = 2.0;
  Features f;
  add_extents(outline, f);
  add_circle(outline, f);
  add_boundary(outline, f);
  f[Feature::leg_radius] = bounded(leg.radius, 1.0);
  f[Feature::leg_residual] = bounded(leg.residual, 1.0);
  f[Feature::right_jump] = bounded(outline.right.jump, kFarJump);
  f[Feature::left_jump] = bounded(outline.left.jump, kFarJump);
  f[Feature::least_jump] = std::min(f[Feature::right_jump], f[Feature::left_jump]);
  f[Feature::spacing] = static_cast<float>(outline.spacing);
  f[Feature::nearest] = static_cast<float>(neighbours.nearest);
  f[Feature::second_nearest] = static_cast<float>(neighbours.second);
  f[Feature::nearest_width] = static_cast<float>(neighbours.width);
  f[Feature::about] = static_cast<float>(neighbours.about);
  return f;
}

}  // namespace bw::people
