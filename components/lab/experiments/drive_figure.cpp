#include "components/lab/experiments/drive_figure.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "components/evaluation/axis_ticks.hpp"
#include "components/evaluation/picture_view.hpp"
#include "components/lab/experiments/figure.hpp"
#include "components/lab/experiments/line_plot.hpp"
#include "components/lab/experiments/path_plot.hpp"
#include "components/model/rim_gap.hpp"

namespace bw {
namespace {

constexpr double kBetweenBodies = 4.0;  // [s]
constexpr double kNear = 3.0;           // [m] people farther away are not drawn with their bodies
constexpr double kFarthest = 5.0;       // [m] end of the axis of distances
const PlotStyle kRobot{.color = kBlue, .width = 2.2};
const PlotStyle kPeople{.color = kPurple, .width = 0.9, .opacity = 0.6};

void add_bodies(PathPlot& plot, const RunRecording& course) {
  double next = 0.0;
  for (const RecordedMoment& moment : course.moments) {
    if (moment.time + 1e-6 < next) continue;
    next = (std::floor(moment.time / kBetweenBodies + 1e-6) + 1.0) * kBetweenBodies;
    const Vector2 robot = moment.X_MB.position();
    plot.discs.push_back({robot, course.robot.radius, kBlue, fixed(moment.time, 0)});
    for (const TruePerson& person : moment.people) {
      if ((person.position - robot).norm() <= kNear)
        plot.discs.push_back({person.position, person.radius, kPurple, fixed(moment.time, 0)});
    }
  }
}

PathPlot map_plot(const RunRecording& course) {
  constexpr double kLongestHop = 2.5;  // [m] farther between two moments: another stay in the scene
  PathPlot plot{.title = "Way and people; numbers are seconds"};
  if (!course.moments.empty()) plot.view = view_of(course, kPlotWidth, {0.0, 0.0}).window_in_map;
  if (course.map) plot.map = &*course.map;
  plot.walls = course.shapes.segments;
  std::map<std::uint32_t, std::size_t> open;  // way of each person
  PlotWay robot{kRobot, {}};
  for (const RecordedMoment& moment : course.moments) {
    robot.points.push_back(moment.X_MB.position());
    for (const TruePerson& person : moment.people) {
      const auto known = open.find(person.id);
      const bool goes_on = known != open.end() &&
                           (plot.ways[known->second].points.back() - person.position).norm() < kLongestHop;
      if (!goes_on) {
        open[person.id] = plot.ways.size();
        plot.ways.push_back({kPeople, {}});
      }
      plot.ways[open[person.id]].points.push_back(person.position);
    }
  }
  plot.ways.push_back(std::move(robot));
  for (const Vector2& goal : course.goals) plot.discs.push_back({goal, 0.15, kGreen});
  for (const Disc& disc : course.shapes.discs) plot.discs.push_back({disc.center, disc.radius, "#34414f"});
  add_bodies(plot, course);
  return plot;
}

LinePlot speed_plot(const RunRecording& course, double end) {
  LinePlot plot{.title = "Speed", .x = {"time [s]", 0.0, end}, .y = {"v [m/s]", 0.0, 1.1 * course.top_speed}};
  plot.curves.push_back({kRobot, {}});
  for (const RecordedMoment& moment : course.moments)
    plot.curves[0].points.emplace_back(moment.time, moment.speed);
  return plot;
}

/// Between outlines; a stretch without anybody in reach lies at the end of the axis.
LinePlot distance_plot(const RunRecording& course, double end) {
  LinePlot plot{.title = "Distance to the nearest person",
                .x = {"time [s]", 0.0, end},
                .y = {"gap [m]", 0.0, kFarthest},
                .limits = {{0.45, "0.45 m intimate"}}};
  plot.curves.push_back({{.color = kPurple, .width = 2.0}, {}});
  for (const RecordedMoment& moment : course.moments) {
    double gap = kFarthest;
    for (const TruePerson& person : moment.people)
      gap = std::min(gap, rim_gap(course.robot, moment.X_MB, person.position, person.radius));
    plot.curves[0].points.emplace_back(moment.time, std::max(gap, 0.0));
  }
  return plot;
}

}  // namespace

std::string drive_figure(const RunRecording& course, const std::string& name, const std::string& caption) {
  const double end = course.moments.empty() ? 1.0 : std::max(1.0, course.moments.back().time);
  return to_html({.title = name,
                  .caption = caption,
                  .legend = {{"robot, every 4 s", {.color = kBlue}, LegendSymbol::body},
                             {"people within 3 m then", {.color = kPurple}, LegendSymbol::body},
                             {"people's ways", kPeople},
                             {"goal", {.color = kGreen}, LegendSymbol::body}},
                  .pictures = {to_svg(map_plot(course)), to_svg(speed_plot(course, end)),
                               to_svg(distance_plot(course, end))}});
}

}  // namespace bw
