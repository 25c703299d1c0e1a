#include "components/lab/bench/buildings/furniture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::buildings {
namespace {

constexpr double kLeast = 0.35;   // of a piece [m]
constexpr double kSampled = 0.1;  // the route, each so many metres
constexpr int kAttempts = 20;     // for each piece

/// Places of the route that a piece in the area could be near to.
std::vector<Vector2> route_near(const FloorPlan& plan, const Rectangle& area) {
  const Vector2 margin = Vector2::Constant(1.0);
  const Rectangle around{area.low - margin, area.high + margin};
  std::vector<Vector2> places;
  for (std::size_t i = 1; i < plan.route.size(); ++i) {
    const Vector2 way = plan.route[i] - plan.route[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(way.norm() / kSampled)));
    for (int k = 0; k <= parts; ++k) {
      const Vector2 place = plan.route[i - 1] + way * (static_cast<double>(k) / parts);
      if (around.contains(place)) places.push_back(place);
    }
  }
  return places;
}

StandingBox drawn_piece(const Rectangle& area, const FurnitureOptions& options, Random& random) {
  const double width = random.uniform(kLeast, options.longest);
  const double depth = random.uniform(kLeast, options.deepest);
  const Vector2 place(random.uniform(area.low.x(), area.high.x()),
                      random.uniform(area.low.y(), area.high.y()));
  const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
  const double off_wall = depth / 2.0 + random.uniform(0.02, 0.1);
  const int side = static_cast<int>(random.uniform(0.0, 4.0));
  if (random.uniform() >= options.along_walls) return {{place.x(), place.y(), angle}, {width, depth}};
  switch (side) {
    case 0:
      return {{place.x(), area.low.y() + off_wall, 0.0}, {width, depth}};
    case 1:
      return {{place.x(), area.high.y() - off_wall, 0.0}, {width, depth}};
    case 2:
      return {{area.low.x() + off_wall, place.y(), 0.0}, {depth, width}};
    default:
      return {{area.high.x() - off_wall, place.y(), 0.0}, {depth, width}};
  }
}

bool fits(const StandingBox& box, const FloorPlan& plan, const Rectangle& area,
          const std::vector<Vector2>& route) {
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      if (!area.contains(box.X_plan_box * Vector2(x * box.size.x(), y * box.size.y()))) return false;
    }
  }
  const bool is_on_another = std::ranges::any_of(plan.boxes, [&](const StandingBox& other) {
    const double apart = (other.X_plan_box.position() - box.X_plan_box.position()).norm();
    return apart < (other.size.norm() + box.size.norm()) / 2.0;
  });
  // Between two samples the route may be a little nearer.
  constexpr double kEnough = kRouteClearance + 0.05;
  return !is_on_another &&
         std::ranges::all_of(route, [&](const Vector2& p) { return distance_to(box, p) >= kEnough; });
}

}  // namespace

void furnish(FloorPlan& plan, const Rectangle& area, const FurnitureOptions& options, Random& random) {
  const std::vector<Vector2> route = route_near(plan, area);
  for (int i = 0; i < options.count; ++i) {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const StandingBox box = drawn_piece(area, options, random);
      if (!fits(box, plan, area, route)) continue;
      plan.boxes.push_back(box);
      break;
    }
  }
}

}  // namespace bw::buildings
