#include "components/lab/bench/buildings/floor_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bw::buildings {
namespace {

/// Edges of all rectangles along one axis, ascending.
std::vector<double> edges_along(const std::vector<Rectangle>& free, int axis) {
  std::vector<double> edges;
  for (const Rectangle& r : free) edges.insert(edges.end(), {r.low[axis], r.high[axis]});
  std::ranges::sort(edges);
  edges.erase(std::ranges::unique(edges).begin(), edges.end());
  return edges;
}

/// Borders that run along `axis`: between two neighbouring strips, wherever one is free and the other solid.
void add_borders(const std::vector<Rectangle>& free, int axis, std::vector<Segment>& borders) {
  const std::vector<double> along = edges_along(free, axis);
  const std::vector<double> across = edges_along(free, 1 - axis);
  const auto at = [&](double a, double c) { return axis == 0 ? Vector2(a, c) : Vector2(c, a); };
  const auto is_free = [&](std::size_t i, std::size_t j) {  // j: strip between across[j - 1] and across[j]
    if (j == 0 || j == across.size()) return false;
    const Vector2 middle = at((along[i] + along[i + 1]) / 2.0, (across[j - 1] + across[j]) / 2.0);
    return std::ranges::any_of(free, [&](const Rectangle& r) { return r.contains(middle); });
  };
  for (std::size_t j = 0; j < across.size(); ++j) {
    int open = 0;  // which side of the border that is being drawn is free; 0: there is none
    for (std::size_t i = 0; i < along.size(); ++i) {
      const bool is_last = i + 1 == along.size();
      const int side = is_last ? 0 : static_cast<int>(is_free(i, j + 1)) - static_cast<int>(is_free(i, j));
      if (side == open) continue;
      const Vector2 corner = at(along[i], across[j]);
      if (open != 0) borders.back().b = corner;
      if (side != 0) borders.push_back({corner, corner});
      open = side;
    }
  }
}

}  // namespace

double distance_to(const StandingBox& box, const Vector2& point) {
  const Vector2 in_box = inverse(box.X_plan_box) * point;
  return (in_box.cwiseAbs() - box.size / 2.0).cwiseMax(0.0).norm();
}

void FloorPlan::carve(const Vector2& a, const Vector2& b) {
  const auto snapped = [](const Vector2& p) { return Vector2((p * 1e3).array().round() * 1e-3); };
  free.push_back({snapped(a.cwiseMin(b)), snapped(a.cwiseMax(b))});
}

void FloorPlan::carve_corridor(const Vector2& a, const Vector2& b, double width) {
  const Vector2 half = Vector2::Constant(width / 2.0);
  carve(a.cwiseMin(b) - half, a.cwiseMax(b) + half);
}

std::vector<Segment> outline(const std::vector<Rectangle>& free) {
  std::vector<Segment> borders;
  add_borders(free, 0, borders);
  add_borders(free, 1, borders);
  return borders;
}

Building build(const FloorPlan& plan, Random& random) {
  Building building;
  const Pose2 turn{0.0, 0.0, random.uniform(-std::numbers::pi, std::numbers::pi)};
  const bool backwards = random.uniform() < 0.5;
  const Vector2 origin = backwards ? plan.route.back() : plan.route.front();
  const auto placed = [&](const Vector2& p) { return Vector2(turn * Vector2(p - origin)); };

  for (const Segment& wall : outline(plan.free)) building.walls.push_back({placed(wall.a), placed(wall.b)});
  for (const StandingBox& box : plan.boxes) {
    std::array<Vector2, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector2 signs(i == 0 || i == 3 ? 0.5 : -0.5, i < 2 ? 0.5 : -0.5);
      corners[i] = placed(box.X_plan_box * Vector2(signs.cwiseProduct(box.size)));
    }
    for (std::size_t i = 0; i < 4; ++i) building.walls.push_back({corners[i], corners[(i + 1) % 4]});
  }
  for (const Rectangle& room : plan.rooms) building.rooms.push_back(placed(room.center()));
  for (const Vector2& corner : plan.route) building.route.push_back(placed(corner));
  if (backwards) std::ranges::reverse(building.route);
  return building;
}

}  // namespace bw::buildings
