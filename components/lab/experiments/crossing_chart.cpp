#include "components/lab/experiments/crossing_chart.hpp"

#include <cmath>

#include <fmt/format.h>

namespace bw {
namespace {

using report::Color;
using report::Look;

const std::vector<double> kStamps = {3.5, 5.0};  // [s] shortly before they meet, and when they do
constexpr double kShownTime = 20.0;              // [s]
const Eigen::AlignedBox2d kView(Vector2(-0.7, -4.3), Vector2(10.7, 4.3));

std::vector<Vector2> positions(const std::vector<TrajectoryPoint>& trajectory) {
  std::vector<Vector2> points;
  for (const TrajectoryPoint& point : trajectory) points.push_back(point.pose.position());
  return points;
}

/// Small arrows along the chosen band, as the source draws them.
void add_arrows(report::Chart& plan, const std::vector<TrajectoryPoint>& trajectory) {
  constexpr double kApart = 0.6, kLength = 0.35;  // [m]
  Vector2 last = Vector2::Constant(1e9);
  for (const TrajectoryPoint& point : trajectory) {
    if ((point.pose.position() - last).norm() < kApart) continue;
    last = point.pose.position();
    plan.bodies.push_back({.center = last,
                           .radius = 0.0,
                           .color = Color::vermilion,
                           .arrow = kLength * direction(point.pose.theta)});
  }
}

report::Chart snapshot_chart(const std::string& label, const CrossingSnapshot& moment) {
  report::Chart plan = report::floor_plan(fmt::format(
      "{}, t = {:.1f} s{}", label, moment.time, moment.plan.trajectory.empty() ? ": no band, it stops" : ""));
  plan.show(kView);
  plan.series.push_back({"chosen band, with its headings",
                         {.color = Color::green, .width = 2.4},
                         positions(moment.plan.trajectory)});
  for (const Candidate& candidate : moment.plan.candidates)
    if (!candidate.chosen)
      plan.series.push_back({"other candidates",
                             {.color = Color::grey, .dash = report::Dash::dashes, .width = 1.2},
                             positions(candidate.trajectory)});
  plan.series.push_back({"driven so far", {.color = Color::blue, .width = 1.4}, moment.path});
  add_arrows(plan, moment.plan.trajectory);
  plan.bodies.push_back({.center = moment.robot.position(),
                         .color = Color::blue,
                         .arrow = 0.3 * direction(moment.robot.theta),
                         .name = "robot"});
  const char* name = "A";
  for (const Mover& person : moment.people) {
    plan.bodies.push_back({person.position, person.radius, Color::purple, name, person.velocity,
                           "people; the arrow is 1 s of their walk"});
    name = "B";
  }
  return plan;
}

bool is_published(const CrossingResult& result) { return !result.entry.set.empty(); }

void add_walkers(report::Chart& plan, const Scene& scene) {
  char name = 'A';
  for (const SceneObstacle& person : scene.obstacles) {
    for (int second = 0; second <= static_cast<int>(kShownTime); ++second) {
      const Vector2 position = person.position + second * person.velocity;
      if (kView.contains(position))
        plan.bodies.push_back({.center = position,
                               .radius = person.radius,
                               .label = name + std::to_string(second),
                               .name = "people, every second"});
    }
    ++name;
  }
}

/// A dot every second.
void add_path(report::Chart& plan, const CrossingResult& result, std::size_t run, const Look& look) {
  plan.series.push_back({result.entry.planner, look});
  for (const TimedPosition& p : result.runs.at(run).path) {
    if (p.time > kShownTime || !kView.contains(p.position)) break;
    plan.series.back().points.push_back(p.position);
    if (std::abs(p.time - std::round(p.time)) < 1e-6)
      plan.marks.push_back({.at = p.position, .color = look.color});
  }
}

}  // namespace

report::Figure crossing_snapshots_figure(const std::vector<CrossingResult>& results,
                                         const CrossingGeometry& geometry, const std::string& source,
                                         std::uint64_t seed) {
  report::Figure figure{
      .title = source + " again: snapshots at two time stamps",
      .caption =
          "What each planner considers and chooses (seed " + std::to_string(seed) +
          "). The source shows TEB with several bands and, beside it, its own; here the published forms come "
          "first, then the planners as they drive by default, which meet people where they will be. Its "
          "places and times are not given: the scene is a proposal.",
      .columns = 2};
  for (const bool published : {true, false}) {
    for (const CrossingResult& result : results) {
      if (result.entry.planner == "teb" || is_published(result) != published) continue;
      for (const CrossingSnapshot& moment : crossing_snapshots(result.entry, geometry, seed, kStamps))
        figure.add(snapshot_chart(result.entry.label, moment));
    }
  }
  return figure;
}

report::Figure crossing_paths_figure(const std::vector<CrossingResult>& results,
                                     const CrossingGeometry& geometry, std::size_t run) {
  const std::uint64_t seed = results.at(0).runs.at(run).seed;
  report::Figure figure{
      .title = "The whole ways",
      .caption = "Seed " + std::to_string(seed) +
                 ". A dot every second on the robot's ways; A2 is where A is after 2 s. Passing "
                 "behind A means crossing x = 4 when A has already gone by.",
      .columns = 2};
  const Scene scene = crossing_scene(geometry, seed);
  for (const bool published : {false, true}) {
    report::Chart plan = report::floor_plan(published ? "As published" : "By default");
    plan.show(kView);
    add_walkers(plan, scene);
    for (const CrossingResult& result : results)
      if (is_published(result) == published) add_path(plan, result, run, report::look_of(plan.series.size()));
    if (!plan.series.empty()) figure.add(plan);
  }
  return figure;
}

}  // namespace bw
