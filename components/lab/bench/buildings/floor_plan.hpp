// A building while it is being planned: free places cut out of solid ground, and boxes that stand in them.
// Frame: the plan's, whose axes are those of the walls. Metres.
#pragma once

#include <cstdint>
#include <vector>

#include "components/lab/bench/buildings/building.hpp"
#include "components/model/random.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::buildings {

inline constexpr double kWallThickness = 0.12;

/// Axis-aligned.
struct Rectangle {
  Vector2 low{0.0, 0.0};
  Vector2 high{0.0, 0.0};

  Vector2 center() const { return (low + high) / 2.0; }
  bool contains(const Vector2& p) const {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
};

/// Solid from the floor to above the laser.
struct StandingBox {
  Pose2 X_plan_box;  ///< of its centre
  Vector2 size{0.0, 0.0};
};
double distance_to(const StandingBox& box, const Vector2& point);  ///< 0 inside

struct FloorPlan {
  std::vector<Rectangle> free;
  std::vector<StandingBox> boxes;
  std::vector<Rectangle> rooms;
  std::vector<Vector2> route;

  /// Makes free what lies between two opposite corners, to the millimetre: edges that should coincide do.
  void carve(const Vector2& a, const Vector2& b);
  /// A corridor `width` wide along an axis, from `a` to `b` and half its width beyond either.
  void carve_corridor(const Vector2& a, const Vector2& b, double width);
};

/// Outline of the union of rectangles.
std::vector<Segment> outline(const std::vector<Rectangle>& free);

/// The plan as a building: it is turned by a drawn angle about its first place of the route, and half of them
/// are driven from the other end.
Building build(const FloorPlan& plan, Random& random);

// One function for each kind.
/// arrangement > 0: the same rooms and route, with other furniture.
FloorPlan plan_office(Random& random, std::uint64_t arrangement);
FloorPlan plan_corridors(Random& random);
FloorPlan plan_loop(Random& random);
FloorPlan plan_pillars(Random& random);
FloorPlan plan_warehouse(Random& random);
FloorPlan plan_campus(Random& random);

}  // namespace bw::buildings
