#include "components/world/static_scene.hpp"

#include <utility>

#include "components/model/nearest_point.hpp"

namespace bw {

StaticScene::StaticScene(StaticObstacles shapes, const std::optional<OccupancyGrid>& map)
    : shapes_(std::move(shapes)) {
  if (map) grid_.emplace(*map);
}

std::optional<Vector2> StaticScene::nearest_point(const Vector2& point, double limit) const {
  std::optional<Vector2> nearest;
  double best = limit;
  const auto consider = [&](const Vector2& candidate) {
    const double distance = (candidate - point).norm();
    if (distance > best) return;
    best = distance;
    nearest = candidate;
  };
  for (const Segment& segment : shapes_.segments) consider(bw::nearest_point(segment, point));
  for (const Disc& disc : shapes_.discs) consider(bw::nearest_point(disc, point));
  if (grid_) {
    if (const auto solid = grid_->nearest_point(point, best)) consider(*solid);
  }
  return nearest;
}

double StaticScene::clearance(const Vector2& point, double limit) const {
  const auto nearest = nearest_point(point, limit);
  return nearest ? (*nearest - point).norm() : limit;
}

}  // namespace bw
