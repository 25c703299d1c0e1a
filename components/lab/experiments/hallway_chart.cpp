#include "components/lab/experiments/hallway_chart.hpp"

#include <algorithm>

#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using report::Color;

constexpr std::string_view kPublished = ", published";
constexpr double kCoarse = 0.5;  // [s] of the drives in the background
const std::vector<report::Limit> kIndexLimits = {{0.54, "0.54 physical"}, {0.14, "0.14 comfort"}};

bool is_published(const std::string& label) { return label.ends_with(kPublished); }

using Drives = std::vector<const HallwayDrive*>;

/// Labels in the order of the drives; the published forms after the defaults.
std::vector<std::string> labels(const Drives& drives) {
  std::vector<std::string> found;
  for (const HallwayDrive* drive : drives)
    if (std::ranges::find(found, drive->planner) == found.end()) found.push_back(drive->planner);
  std::ranges::stable_partition(found, [](const std::string& label) { return !is_published(label); });
  return found;
}

Drives by_ideal_senses(const std::vector<HallwayDrive>& drives, const std::string& episode,
                       bool people_react) {
  Drives found;
  for (const HallwayDrive& drive : drives)
    if (!drive.own_senses && drive.episode == episode && drive.people_react == people_react)
      found.push_back(&drive);
  return found;
}

/// Of each stretch of `period` [s] the highest.
std::vector<Vector2> coarse(const std::vector<Vector2>& course, double period) {
  std::vector<Vector2> points;
  double end = 0.0;
  for (const Vector2& p : course) {
    if (points.empty() || p.x() >= end) {
      points.push_back(p);
      end = p.x() + period;
    } else if (p.y() > points.back().y()) {
      points.back() = p;
    }
  }
  return points;
}

report::Chart course_chart(const std::string& label, const Drives& drives, double longest) {
  report::Chart chart{.title = label,
                      .x = {"time [s]", 0.0, longest},
                      .y = {"collision index", 0.0, 1.0},
                      .limits = kIndexLimits};
  const std::vector<Vector2>* first = nullptr;
  for (const HallwayDrive* drive : drives) {
    if (drive->planner != label) continue;
    if (first != nullptr)
      chart.series.push_back({"other seeds",
                              {.color = Color::grey, .width = 0.7, .opacity = 0.6},
                              coarse(drive->course, kCoarse)});
    if (first == nullptr) first = &drive->course;
  }
  if (first != nullptr) chart.series.push_back({"first seed", {.color = Color::blue, .width = 2.0}, *first});
  return chart;
}

report::Columns largest_of(const Drives& drives, bool published) {
  report::Columns all{.title = {},
                      .y = {"largest collision index", 0.0, 1.0},
                      .measured = "median, 5 to 95 % of the seeds",
                      .runs = "a drive",
                      .limits = kIndexLimits};
  for (const std::string& label : labels(drives)) {
    if (is_published(label) != published) continue;
    report::Column column{.label = label.substr(0, label.find(','))};
    for (const HallwayDrive* drive : drives)
      if (drive->planner == label) column.runs.push_back(drive->max_collision_index);
    column.measured = report::Interval{quantile(column.runs, 0.5), quantile(column.runs, 0.05),
                                       quantile(column.runs, 0.95)};
    all.columns.push_back(std::move(column));
  }
  return all;
}

}  // namespace

report::Figure hallway_courses_figure(const std::vector<HallwayDrive>& drives, const std::string& episode,
                                      const std::string& source) {
  Drives meant = by_ideal_senses(drives, episode, true);
  std::erase_if(meant, [](const HallwayDrive* drive) { return drive->course.empty(); });
  double longest = 0.0;
  for (const HallwayDrive* drive : meant) longest = std::max(longest, drive->course.back().x());
  const std::vector<std::string> planners = labels(meant);
  report::Figure figure{
      .title = source + " again: the collision index along the drives, " + episode + " hallway",
      .caption =
          "People who react, ideal senses. The source shows one drive each and its threshold of 0.54, "
          "in a hallway whose measures it does not give.",
      .columns = std::ranges::find(planners, "eteb") != planners.end() ? 3 : 2};
  for (const std::string& label : planners)  // the planner with several bands and no more is left out
    if (!label.starts_with("teb_homotopy")) figure.add(course_chart(label, meant, longest));
  return figure;
}

report::Figure hallway_largest_figure(const std::vector<HallwayDrive>& drives) {
  report::Figure figure{.title = "The largest collision index of every drive, ideal senses",
                        .caption = "Not in the source, which shows single drives.",
                        .columns = 2};
  for (const bool react : {true, false}) {
    for (const char* episode : {"full", "light"}) {
      const Drives meant = by_ideal_senses(drives, episode, react);
      for (const bool published : {false, true}) {
        report::Columns all = largest_of(meant, published);
        if (all.columns.empty()) continue;
        all.title = std::string(episode) + ", people " + (react ? "react" : "do not react") +
                    (published ? "; as published" : "; by default");
        figure.add(all);
      }
    }
  }
  return figure;
}

}  // namespace bw
