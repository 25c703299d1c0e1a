#include "components/lab/experiments/drive_chart.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "components/evaluation/collision_index.hpp"
#include "components/evaluation/picture_view.hpp"
#include "components/model/rim_gap.hpp"

namespace bw {
namespace {

using report::Color;

constexpr double kBetweenDrawn = 4.0;  // [s]
constexpr double kNear = 3.0;          // [m] people farther away are not drawn with their bodies
constexpr double kFarthest = 5.0;      // [m] end of the axis of distances
constexpr double kLongestHop = 2.5;    // [m] farther between two moments: another stay in the scene
constexpr std::size_t kMax = 200;      // of the course of an index

void add_bodies(report::Chart& plan, const RunRecording& course) {
  double next = 0.0;
  for (const RecordedMoment& moment : course.moments) {
    if (moment.time + 1e-6 < next) continue;
    next = (std::floor(moment.time / kBetweenDrawn + 1e-6) + 1.0) * kBetweenDrawn;
    const Vector2 robot = moment.X_MB.position();
    const std::string label = fmt::format("{:.0f}", moment.time);
    plan.bodies.push_back({robot, course.robot.radius, Color::blue, label, {0.0, 0.0}, "robot, every 4 s"});
    for (const TruePerson& person : moment.people)
      if ((person.position - robot).norm() <= kNear)
        plan.bodies.push_back(
            {person.position, person.radius, Color::purple, label, {0.0, 0.0}, "people within 3 m then"});
  }
}

void add_paths(report::Chart& plan, const RunRecording& course) {
  std::map<std::uint32_t, std::size_t> open;  // path of each person
  report::Series robot{"robot", {.color = Color::blue, .width = 2.2}};
  for (const RecordedMoment& moment : course.moments) {
    robot.points.push_back(moment.X_MB.position());
    for (const TruePerson& person : moment.people) {
      const auto known = open.find(person.id);
      const bool goes_on = known != open.end() &&
                           (plan.series[known->second].points.back() - person.position).norm() < kLongestHop;
      if (!goes_on) {
        open[person.id] = plan.series.size();
        plan.series.push_back({"people's ways", {.color = Color::purple, .width = 0.9, .opacity = 0.6}});
      }
      plan.series[open[person.id]].points.push_back(person.position);
    }
  }
  plan.series.push_back(std::move(robot));
}

report::Chart map_chart(const RunRecording& course) {
  report::Chart plan = report::floor_plan("Way and people; numbers are seconds");
  if (!course.moments.empty()) {
    const Eigen::AlignedBox2d window = view_of(course, 1.0, {0.0, 0.0}).window_in_map;
    plan.show(window);
    if (course.map) plan.blocks = cell_blocks(*course.map, window, 65, 100);
  }
  plan.walls = course.shapes.segments;
  add_paths(plan, course);
  for (const Vector2& goal : course.goals)
    plan.bodies.push_back({goal, 0.15, Color::green, "", {0.0, 0.0}, "goal"});
  for (const Disc& disc : course.shapes.discs)
    plan.bodies.push_back({.center = disc.center, .radius = disc.radius, .color = Color::ink});
  add_bodies(plan, course);
  return plan;
}

report::Chart speed_chart(const RunRecording& course, double end) {
  report::Chart chart{
      .title = "Speed", .x = {"time [s]", 0.0, end}, .y = {"v [m/s]", 0.0, 1.1 * course.top_speed}};
  chart.series.push_back({"", {.color = Color::blue, .width = 2.2}});
  for (const RecordedMoment& moment : course.moments)
    chart.series[0].points.emplace_back(moment.time, moment.speed);
  return chart;
}

/// Between outlines; a stretch without anybody in reach lies at the end of the axis.
report::Chart distance_chart(const RunRecording& course, double end) {
  report::Chart chart{.title = "Distance to the nearest person",
                      .x = {"time [s]", 0.0, end},
                      .y = {"gap [m]", 0.0, kFarthest},
                      .limits = {{0.45, "0.45 m intimate"}}};
  chart.series.push_back({"", {.color = Color::purple, .width = 2.0}});
  for (const RecordedMoment& moment : course.moments) {
    double gap = kFarthest;
    for (const TruePerson& person : moment.people)
      gap = std::min(gap, rim_gap(course.robot, moment.X_MB, person.position, person.radius));
    chart.series[0].points.emplace_back(moment.time, std::max(gap, 0.0));
  }
  return chart;
}

}  // namespace

report::Figure drive_figure(const RunRecording& course, const std::string& name, const std::string& caption) {
  const double end = course.moments.empty() ? 1.0 : std::max(1.0, course.moments.back().time);
  report::Figure figure{.title = name, .caption = caption};
  figure.add(map_chart(course));
  figure.add(speed_chart(course, end));
  figure.add(distance_chart(course, end));
  return figure;
}

std::vector<Vector2> index_course(const RunRecording& recording) {
  const std::vector<RecordedMoment>& moments = recording.moments;
  const std::size_t stretch = (moments.size() + kMax - 1) / kMax;
  std::vector<Vector2> course;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Vector2 now(moments[i].time,
                      collision_index(moments[i].X_MB.position(), moments[i].people, kJudgingSigma));
    if (i % stretch == 0) {
      course.push_back(now);
    } else if (now.y() > course.back().y()) {
      course.back() = now;
    }
  }
  return course;
}

}  // namespace bw
