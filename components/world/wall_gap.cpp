#include "components/world/wall_gap.hpp"

#include <algorithm>

#include "components/model/footprint_distance.hpp"

namespace bw {

double wall_gap(const StaticScene& scene, const Footprint& footprint, const Pose2& pose, double limit) {
  const double from_center = scene.clearance(pose.position(), footprint.radius + limit);
  if (!footprint.is_polygon()) return from_center - footprint.radius;
  if (from_center >= footprint.radius + limit) return limit;
  double gap = limit;
  const auto look_at = [&](const Vector2& a, const Vector2& b, double radius) {
    gap = std::min(gap, gap_to(footprint, pose, {a, b, radius}, gap));
  };
  for (const Segment& wall : scene.segments()) look_at(wall.a, wall.b, 0.0);
  for (const Disc& disc : scene.discs()) look_at(disc.center, disc.center, disc.radius);
  if (!scene.grid()) return gap;
  // What is farther from the centre than the nearest thing by more than the outline varies is farther from
  // the rim.
  const double reach = from_center + footprint.radius - inscribed_radius(footprint);
  for (const Segment& edge : scene.grid()->edges_within(pose.position(), reach)) look_at(edge.a, edge.b, 0.0);
  return gap;
}

}  // namespace bw
