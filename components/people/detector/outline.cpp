#include "components/people/detector/outline.hpp"

namespace bw::people {

void read_outline(const Beams& beams, const Clusters& clusters, const Cluster& cluster, Outline& outline) {
  const auto members = clusters.beams_of(cluster);
  Vector2 mean{0.0, 0.0};
  for (const int beam : members) mean += beams.points[static_cast<std::size_t>(beam)];
  mean /= static_cast<double>(members.size());
  const Vector2 sight = mean - beams.sensor;
  const double bearing = std::atan2(sight.y(), sight.x());
  outline.X_OC = {mean.x(), mean.y(), bearing};
  outline.distance = sight.norm();
  outline.angle_increment = beams.angle_increment;
  outline.spacing = outline.distance * beams.angle_increment;
  outline.right = cluster.right;
  outline.left = cluster.left;
  outline.points.clear();
  const Vector2 x_axis = direction(bearing);
  for (const int beam : members) {
    const Vector2 offset = beams.points[static_cast<std::size_t>(beam)] - mean;
    outline.points.emplace_back(x_axis.dot(offset), cross(x_axis, offset));
  }
  const auto ray = [&](int beam, double half) {
    return direction(beams.angle_min + (beam + half) * beams.angle_increment - bearing);
  };
  outline.right_ray = ray(members.front(), -0.5);
  outline.left_ray = ray(members.back(), 0.5);
}

}  // namespace bw::people
