// Drawings of what a laser shows of people, and of where a robot may drive how fast.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "components/global_planner/costs.hpp"
#include "components/lab/figures/figures.hpp"
#include "components/lab/figures/plane.hpp"
#include "components/lab/figures/room.hpp"
#include "components/model/cell_cost.hpp"
#include "components/people/detector/detector.hpp"
#include "components/safety/free_distance.hpp"
#include "components/world/laser_scanner.hpp"
#include "components/world/legs.hpp"

namespace bw::figures {
std::string leg_evidence() {
  const Pose2 X_ML(1.2, 2.6, 0.15);
  const std::vector<Person> people = {{.id = 1, .position = {4.2, 2.9}, .velocity = {0.1, -1.1}},
                                      {.id = 2, .position = {3.2, 1.7}}};
  Legs legs(LegOptions{});
  for (int i = 0; i < 7; ++i) legs.step(0.1, people);
  const std::vector<Disc> leg_discs = legs.discs(people);
  const StaticScene scene(room_shapes(), std::nullopt);
  LaserScanner scanner({.beams = 720, .range_noise = 0.01}, Random(2));
  const LaserScan scan = scanner.scan(scene, leg_discs, X_ML);

  people::Detector detector(people::DetectorOptions{});
  LaserSweep sweep;
  sweep.time = Time::seconds(1.0);
  sweep.X_FL = X_ML;
  sweep.angle_min = scan.angle_min;
  sweep.angle_increment = scan.angle_increment;
  sweep.range_min = 0.05;
  sweep.range_max = 20.0;
  sweep.ranges = scan.ranges;
  const people::DetectionSet& detections = detector.detect(sweep, {});

  Plane plane("Legs in a sweep: clusters of beams and their scores",
              Eigen::AlignedBox2d(Vector2(0.8, 0.9), Vector2(5.4, 3.7)),
              {.x = "x [m]", .y = "y [m]", .tick = 0.5, .decimals = 1});
  draw_room(plane);
  for (const Disc& leg : leg_discs) plane.disc(leg.center, leg.radius, kPurple, 0.3);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i)
    if (std::isfinite(scan.ranges[i]))
      plane.dot(X_ML * (static_cast<double>(scan.ranges[i]) *
                        direction(scan.angle_min + static_cast<double>(i) * scan.angle_increment)),
                1.8, kBlue);
  bool is_left = false;
  for (const people::Detection& detection : detections.detections) {
    if (detection.human_score() < 0.2) continue;
    is_left = !is_left;
    plane.disc(detection.position, 0.14, kVermilion, 0.0);
    plane.note(detection.position,
               fmt::format("leg {:.2f}, body {:.2f}", detection.leg_score, detection.body_score),
               is_left ? -136.0 : 16.0, 8.0, kVermilion);
  }
  plane.dot(X_ML.position(), 5.0, kBlack);
  plane.arrow(X_ML.position(), 0.25 * direction(X_ML.theta), kBlack);
  plane.note(X_ML.position(), "laser", -14.0, 12.0);
  plane.key(kBlue, "ends of beams");
  plane.key(kPurple, "legs of a person who walks and of one who stands");
  plane.key(kVermilion, "clusters that may be human, with the classifier's scores");
  return std::move(plane).finish();
}

std::string stopping_distance() {
  const OccupancyGrid map = room_map();
  const Footprint footprint{.radius = 0.3};
  const GlobalPlannerOptions options;
  SearchGrid grid;
  grid.build(map, footprint, options);
  const std::vector<std::uint8_t> costs = costs_of(grid, map, options.clearance_weight);

  Plane plane("Costmap, and the distance in which the robot stops", kRoom, kFloor);
  const auto cost_at = [&](const Vector2& p) {
    return costs[map.index(map.column_of(p.x()), map.row_of(p.y()))];
  };
  plane.shades(0.1, kSky, [&](const Vector2& p) {
    return cost_at(p) < kInscribedCost ? 0.6 * cost_at(p) / kInscribedCost : 0.0;
  });
  plane.shades(0.1, kVermilion, [&](const Vector2& p) { return cost_at(p) == kInscribedCost ? 0.35 : 0.0; });
  plane.shades(0.1, kBlack, [&](const Vector2& p) { return cost_at(p) == kLethalCost ? 0.8 : 0.0; });
  draw_room(plane);
  const Pose2 robot(1.2, 2.4, 0.12);
  plane.disc(robot.position(), footprint.radius, kBlue, 0.4);
  const safety::Stopping stopping{.reaction_time = 0.25, .deceleration = 0.5};
  constexpr std::array kSpeeds{0.3, 0.6, 1.0};
  for (const double speed : kSpeeds) {
    const double distance = speed * stopping.reaction_time + speed * speed / (2.0 * stopping.deceleration);
    const Vector2 end = robot.position() + distance * direction(robot.theta);
    plane.disc(end, footprint.radius, kGreen, 0.05);
    plane.arrow(robot.position(), end - robot.position(), kGreen, 1.2);
    plane.note(end, fmt::format("{:.1f} m/s", speed), -12.0, speed < 0.5 ? -38.0 : 28.0, kGreen);
  }
  const Vector2 wall(3.9, 2.72);
  plane.dot(wall, 4.0, kPurple);
  const double distance = (wall - robot.position()).norm() - footprint.radius;
  plane.note(
      wall,
      fmt::format("{:.2f} m free: at most {:.2f} m/s", distance, safety::speed_within(distance, stopping)),
      8.0, 4.0, kPurple);
  plane.key(kVermilion, "the inscribed disc would touch (253)");
  plane.key(kSky, "cost falls with the distance from obstacles");
  plane.key(kGreen, fmt::format("footprint at rest after {} s of reaction and braking with {} m/s^2",
                                stopping.reaction_time, stopping.deceleration));
  plane.key(kPurple, "somebody in the way, and the speed from which the robot still stops before");
  return std::move(plane).finish();
}

}  // namespace bw::figures
