#include "components/lab/experiments/crossing_figures.hpp"

#include <algorithm>
#include <cmath>

#include "components/lab/experiments/figure.hpp"
#include "components/lab/experiments/path_plot.hpp"

namespace bw {
namespace {

const std::vector<double> kStamps = {3.5, 5.0};  // [s] shortly before they meet, and when they do
constexpr double kShownTime = 20.0;              // [s]
const PlotStyle kChosen{.color = kGreen, .width = 2.4};
const PlotStyle kOthers{.color = kGrey, .dash = "4 2", .width = 1.2};
const PlotStyle kDriven{.color = kBlue, .width = 1.4};

Eigen::AlignedBox2d view() { return {Vector2(-0.7, -4.3), Vector2(10.7, 4.3)}; }

std::vector<Vector2> places(const std::vector<TrajectoryPoint>& trajectory) {
  std::vector<Vector2> points;
  for (const TrajectoryPoint& point : trajectory) points.push_back(point.pose.position());
  return points;
}

/// Small arrows along the chosen band, as the source draws them.
void add_arrows(PathPlot& plot, const std::vector<TrajectoryPoint>& trajectory) {
  constexpr double kApart = 0.6, kLength = 0.35;  // [m]
  Vector2 last = Vector2::Constant(1e9);
  for (const TrajectoryPoint& point : trajectory) {
    if ((point.pose.position() - last).norm() < kApart) continue;
    last = point.pose.position();
    plot.discs.push_back(
        {.center = last, .radius = 0.0, .color = kVermilion, .arrow = kLength * direction(point.pose.theta)});
  }
}

PathPlot snapshot_plot(const std::string& label, const CrossingSnapshot& moment) {
  PathPlot plot{.title = label + ", t = " + fixed(moment.time, 1) + " s"};
  if (moment.plan.trajectory.empty()) plot.title += ": no band, it stops";
  plot.view = view();
  for (const Candidate& candidate : moment.plan.candidates) {
    if (!candidate.chosen) plot.ways.push_back({kOthers, places(candidate.trajectory)});
  }
  plot.ways.push_back({kChosen, places(moment.plan.trajectory)});
  plot.ways.push_back({kDriven, moment.way});
  add_arrows(plot, moment.plan.trajectory);
  const char* name = "A";
  for (const Mover& person : moment.people) {
    plot.discs.push_back({person.position, person.radius, kPurple, name, person.velocity});
    name = "B";
  }
  plot.discs.push_back(
      {.center = moment.robot.position(), .color = kBlue, .arrow = 0.3 * direction(moment.robot.theta)});
  return plot;
}

bool is_published(const CrossingResult& result) { return !result.entry.set.empty(); }

void add_walkers(PathPlot& plot, const Scene& scene) {
  char name = 'A';
  for (const SceneObstacle& person : scene.obstacles) {
    for (int second = 0; second <= static_cast<int>(kShownTime); ++second) {
      const Vector2 place = person.position + second * person.velocity;
      if (view().contains(place))
        plot.discs.push_back({place, person.radius, kGrey, std::string(1, name) + std::to_string(second)});
    }
    ++name;
  }
}

/// A dot every second.
void add_way(PathPlot& plot, const CrossingRun& run, const PlotStyle& style) {
  plot.ways.push_back({style, {}});
  for (const TimedPosition& p : run.path) {
    if (p.time > kShownTime || !view().contains(p.position)) break;
    plot.ways.back().points.push_back(p.position);
    if (std::abs(p.time - std::round(p.time)) < 1e-6)
      plot.discs.push_back({.center = p.position, .radius = 0.07, .color = style.color});
  }
}

}  // namespace

std::vector<CrossingSnapshots> snapshots_of(const std::vector<CrossingResult>& results,
                                            const CrossingGeometry& geometry, std::uint64_t seed) {
  std::vector<CrossingSnapshots> planners;
  for (const bool published : {true, false}) {
    for (const CrossingResult& result : results) {
      if (result.entry.planner == "teb" || is_published(result) != published) continue;
      planners.push_back({result.entry.label, crossing_snapshots(result.entry, geometry, seed, kStamps)});
    }
  }
  return planners;
}

std::string crossing_snapshot_figure(const std::vector<CrossingSnapshots>& planners,
                                     const std::string& source, std::uint64_t seed) {
  Figure figure{
      .title = source + " again: snapshots at two time stamps",
      .caption =
          "What each planner considers and chooses (seed " + std::to_string(seed) +
          "). The source shows TEB with several bands and, beside it, its own; here the published forms come "
          "first, then the planners as they drive by default, which meet people where they will be. Its "
          "places and times are not given: the scene is a proposal.",
      .legend = {{"chosen band, with its headings", kChosen},
                 {"other candidates", kOthers},
                 {"driven so far", kDriven},
                 {"robot", {.color = kBlue}, LegendSymbol::body},
                 {"people; the arrow is 1 s of their walk", {.color = kPurple}, LegendSymbol::body}},
      .columns = 2};
  for (const CrossingSnapshots& planner : planners) {
    for (const CrossingSnapshot& moment : planner.moments)
      figure.pictures.push_back(to_svg(snapshot_plot(planner.label, moment)));
  }
  return to_html(figure);
}

std::string crossing_ways(const std::vector<CrossingResult>& results, const CrossingGeometry& geometry,
                          std::size_t run) {
  const std::uint64_t seed = results.at(0).runs.at(run).seed;
  Figure figure{
      .title = "The whole ways",
      .caption = "Seed " + std::to_string(seed) +
                 ". A dot every second on the robot's ways; A2 is where A is after 2 s. Passing behind A "
                 "means crossing x = 4 when A has already gone by.",
      .columns = 2};
  const Scene scene = crossing_scene(geometry, seed);
  for (const bool published : {false, true}) {
    PathPlot plot{.title = published ? "As published" : "By default"};
    plot.view = view();
    add_walkers(plot, scene);
    std::size_t index = 0;
    for (const CrossingResult& result : results) {
      if (is_published(result) != published) continue;
      if (!published) figure.legend.push_back({result.entry.label, style_of(index)});
      add_way(plot, result.runs.at(run), style_of(index++));
    }
    if (index > 0) figure.pictures.push_back(to_svg(plot));
  }
  figure.legend.push_back({"people, every second", {.color = kGrey}, LegendSymbol::body});
  return to_html(figure);
}

}  // namespace bw
