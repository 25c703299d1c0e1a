#include "components/world/laser_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "components/model/nearest_point.hpp"
#include "components/world/ray.hpp"

namespace bw {

LaserScanner::LaserScanner(const LaserOptions& options, Random random)
    : options_(options),
      angle_min_(-options.field_of_view / 2.0),
      angle_increment_(options.field_of_view / (options.beams - 1)),
      random_(random) {
  const auto beams = static_cast<std::size_t>(options_.beams);
  for (int i = 0; i < options_.beams; ++i) {
    directions_in_laser_.push_back(direction(angle_min_ + i * angle_increment_));
  }
  directions_in_map_.resize(beams);
  hits_.resize(beams);
}

void LaserScanner::aim(const Pose2& X_map_laser) {
  X_map_laser_ = X_map_laser;
  const Vector2 heading = direction(X_map_laser.theta);
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    const Vector2& d = directions_in_laser_[i];
    directions_in_map_[i] = {heading.x() * d.x() - heading.y() * d.y(),
                             heading.y() * d.x() + heading.x() * d.y()};
    hits_[i] = options_.range_max;
  }
}

/// Offers the shape to the beams between two angles of the laser frame, one spare beam on either side.
template <class Shape>
void LaserScanner::draw_between(double first_angle, double width, const Shape& shape) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  for (const double shift : {-kTwoPi, 0.0, kTwoPi}) {
    const double from = std::floor((first_angle + shift - angle_min_) / angle_increment_) - 1.0;
    const double to = std::ceil((first_angle + shift + width - angle_min_) / angle_increment_) + 1.0;
    if (to < 0.0 || from > options_.beams - 1.0) continue;
    const auto last = static_cast<std::size_t>(std::min(to, options_.beams - 1.0));
    for (auto i = static_cast<std::size_t>(std::max(from, 0.0)); i <= last; ++i) {
      hits_[i] = std::min(hits_[i], ray_hit(X_map_laser_.position(), directions_in_map_[i], shape));
    }
  }
}

void LaserScanner::draw(const Segment& segment) {
  const Vector2 to_a = segment.a - X_map_laser_.position();
  const Vector2 to_b = segment.b - X_map_laser_.position();
  if ((nearest_point(segment, X_map_laser_.position()) - X_map_laser_.position()).norm() >=
      options_.range_max)
    return;
  const double angle_a = wrap_angle(std::atan2(to_a.y(), to_a.x()) - X_map_laser_.theta);
  const double sweep = std::atan2(cross(to_a, to_b), to_a.dot(to_b));
  draw_between(std::min(angle_a, angle_a + sweep), std::abs(sweep), segment);
}

void LaserScanner::draw(const Disc& disc) {
  const Vector2 to_center = disc.center - X_map_laser_.position();
  const double distance = to_center.norm();
  if (distance - disc.radius >= options_.range_max) return;
  if (distance <= disc.radius) {
    std::fill(hits_.begin(), hits_.end(), 0.0);
    return;
  }
  const double half_width = std::asin(disc.radius / distance);
  const double angle = wrap_angle(std::atan2(to_center.y(), to_center.x()) - X_map_laser_.theta);
  draw_between(angle - half_width, 2.0 * half_width, disc);
}

LaserScan LaserScanner::scan(const StaticScene& scene, const std::vector<Disc>& movers,
                             const Pose2& X_map_laser) {
  aim(X_map_laser);
  for (const Segment& segment : scene.segments()) draw(segment);
  for (const Disc& disc : scene.discs()) draw(disc);
  for (const Disc& disc : movers) draw(disc);
  if (const auto& grid = scene.grid()) {
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      hits_[i] = std::min(hits_[i], grid->ray_hit(X_map_laser_.position(), directions_in_map_[i], hits_[i]));
    }
  }
  LaserScan result{angle_min_, angle_increment_, std::vector<float>(hits_.size())};
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    const double noise =
        options_.range_noise * random_.normal();  // drawn for every beam: hits never shift the stream
    const double range = hits_[i] + noise;
    const bool none = hits_[i] >= options_.range_max || range > options_.range_max;
    const auto infinity = std::numeric_limits<float>::infinity();
    result.ranges[i] = none ? infinity : range < options_.range_min ? -infinity : static_cast<float>(range);
  }
  return result;
}

}  // namespace bw
