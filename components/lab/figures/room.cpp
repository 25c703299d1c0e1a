#include "components/lab/figures/room.hpp"

#include <cmath>

#include "components/model/differential_drive.hpp"
#include "components/world/static_scene.hpp"

namespace bw::figures {
namespace {

constexpr double kResolution = 0.05;  // [m]
constexpr double kStepTime = 0.05;    // [s]

}  // namespace

StaticObstacles room_shapes() {
  const Vector2 a = kRoom.min() + Vector2(0.1, 0.1), c = kRoom.max() - Vector2(0.1, 0.1);
  const Vector2 b(c.x(), a.y()), d(a.x(), c.y());
  return {.points = {},
          .discs = {{{3.2, 4.1}, 0.25}, {{7.0, 2.2}, 0.25}, {{7.8, 4.4}, 0.25}},
          .segments = {{a, b}, {b, c}, {c, d}, {d, a}, {{4.6, 0.1}, {4.6, 1.2}}, {{5.4, 5.9}, {5.4, 4.6}}}};
}

OccupancyGrid room_map() {
  const StaticScene scene(room_shapes(), std::nullopt);
  OccupancyGrid map{.resolution = kResolution,
                    .origin = kRoom.min(),
                    .width = static_cast<int>(std::lround(kRoom.sizes().x() / kResolution)),
                    .height = static_cast<int>(std::lround(kRoom.sizes().y() / kResolution))};
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column)
      map.cells.push_back(scene.clearance(map.center(column, row), 1.0) <= 0.6 * kResolution
                              ? OccupancyGrid::kOccupied
                              : OccupancyGrid::kFree);
  return map;
}

void draw_room(Plane& plane) {
  const StaticObstacles shapes = room_shapes();
  for (const Segment& wall : shapes.segments) plane.curve({wall.a, wall.b}, kBlack, 3.0);
  for (const Disc& pillar : shapes.discs) plane.disc(pillar.center, pillar.radius, kBlack, 0.6);
}

std::vector<Pose2> path_through_room(int steps) {
  Pose2 pose(1.2, 2.0, 0.35);
  std::vector<Pose2> path{pose};
  for (int i = 0; i < steps; ++i) {
    const double turn_rate = 0.35 * std::cos(0.7 * kStepTime * i + 1.2);  // [rad/s]
    pose = advance_exact(pose, {0.8, turn_rate}, kStepTime);
    path.push_back(pose);
  }
  return path;
}

}  // namespace bw::figures
