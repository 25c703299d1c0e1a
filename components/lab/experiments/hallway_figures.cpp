#include "components/lab/experiments/hallway_figures.hpp"

#include <algorithm>

#include "components/lab/experiments/column_plot.hpp"
#include "components/lab/experiments/figure.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

constexpr std::string_view kPublished = ", published";
constexpr double kCoarse = 0.5;  // [s] of the drives in the background
const std::vector<PlotLimit> kLimits = {{0.54, "0.54 physical"}, {0.14, "0.14 comfort"}};

bool is_published(const HallwayDrive& drive) { return drive.planner.ends_with(kPublished); }

std::string planner_name(const HallwayDrive& drive) {
  return drive.planner.substr(0, drive.planner.find(','));
}

/// Labels in the order of the drives.
std::vector<std::string> labels(const std::vector<const HallwayDrive*>& drives) {
  std::vector<std::string> found;
  for (const HallwayDrive* drive : drives) {
    if (std::find(found.begin(), found.end(), drive->planner) == found.end()) found.push_back(drive->planner);
  }
  return found;
}

std::vector<const HallwayDrive*> by_ideal_senses(const std::vector<HallwayDrive>& drives, const char* episode,
                                                 bool people_react) {
  std::vector<const HallwayDrive*> found;
  for (const HallwayDrive& drive : drives) {
    if (!drive.own_senses && drive.episode == episode && drive.people_react == people_react)
      found.push_back(&drive);
  }
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

LinePlot course_plot(const std::string& label, const std::vector<const HallwayDrive*>& drives,
                     double longest) {
  LinePlot plot{
      .title = label, .x = {"time [s]", 0.0, longest}, .y = {"collision index", 0.0, 1.0}, .limits = kLimits};
  const std::vector<Vector2>* first = nullptr;
  for (const HallwayDrive* drive : drives) {
    if (drive->planner != label || drive->course.empty()) continue;
    if (first == nullptr) {
      first = &drive->course;
      continue;
    }
    plot.curves.push_back({{.color = kGrey, .width = 0.7, .opacity = 0.6}, coarse(drive->course, kCoarse)});
  }
  if (first != nullptr) plot.curves.push_back({{.color = kBlue, .width = 2.0}, *first});
  return plot;
}

/// The published forms after the defaults; the planner with several bands and no more is left out.
std::vector<std::string> shown_planners(const std::vector<const HallwayDrive*>& drives) {
  std::vector<std::string> shown;
  for (const std::string& label : labels(drives)) {
    if (!label.starts_with("teb_homotopy")) shown.push_back(label);
  }
  std::stable_partition(shown.begin(), shown.end(),
                        [](const std::string& label) { return !label.ends_with(kPublished); });
  return shown;
}

std::string courses_of(const std::vector<HallwayDrive>& drives, const char* episode,
                       const std::string& source) {
  std::vector<const HallwayDrive*> meant = by_ideal_senses(drives, episode, true);
  std::erase_if(meant, [](const HallwayDrive* drive) { return drive->course.empty(); });
  if (meant.empty()) return "";
  double longest = 0.0;
  for (const HallwayDrive* drive : meant) longest = std::max(longest, drive->course.back().x());
  const std::vector<std::string> planners = shown_planners(meant);
  const bool has_eteb =
      std::any_of(planners.begin(), planners.end(), [](const auto& p) { return p == "eteb"; });
  Figure figure{
      .title = source + " again: the collision index along the drives, " + episode + " hallway",
      .caption =
          "People who react, ideal senses. The source shows one drive each and its threshold of 0.54, "
          "in a hallway whose measures it does not give.",
      .legend = {{"first seed", {.color = kBlue, .width = 2.0}},
                 {"other seeds", {.color = kGrey, .width = 1.0}},
                 {"limits", {.dash = "4 3", .width = 1.2}}},
      .columns = has_eteb ? 3 : 2};
  for (const std::string& label : planners)
    figure.pictures.push_back(to_svg(course_plot(label, meant, longest)));
  return to_html(figure);
}

ColumnPlot largest_plot(const std::vector<const HallwayDrive*>& drives, bool published) {
  ColumnPlot plot{.title = "", .y = {"largest collision index", 0.0, 1.0}, .columns = {}, .limits = kLimits};
  for (const std::string& label : labels(drives)) {
    if (label.ends_with(kPublished) != published) continue;
    PlotColumn column;
    for (const HallwayDrive* drive : drives) {
      if (drive->planner != label) continue;
      column.label = planner_name(*drive);
      column.runs.push_back(drive->max_collision_index);
    }
    column.measured =
        ColumnSpread{quantile(column.runs, 0.5), quantile(column.runs, 0.05), quantile(column.runs, 0.95)};
    plot.columns.push_back(std::move(column));
  }
  return plot;
}

}  // namespace

std::string hallway_courses(const std::vector<HallwayDrive>& drives, const std::string& source) {
  return courses_of(drives, "full", source) + courses_of(drives, "light", source);
}

std::string hallway_largest_indices(const std::vector<HallwayDrive>& drives) {
  Figure figure{.title = "The largest collision index of every drive, ideal senses",
                .caption = "Not in the source, which shows single drives.",
                .legend = {{"a drive", {.color = kBlue}, LegendSymbol::dots},
                           {"median, 5 to 95 % of the seeds", {.color = kBlue}, LegendSymbol::measured}},
                .columns = 2};
  for (const bool react : {true, false}) {
    for (const char* episode : {"full", "light"}) {
      const std::vector<const HallwayDrive*> meant = by_ideal_senses(drives, episode, react);
      for (const bool published : {false, true}) {
        if (std::none_of(meant.begin(), meant.end(),
                         [&](const auto* d) { return is_published(*d) == published; }))
          continue;
        ColumnPlot plot = largest_plot(meant, published);
        plot.title = std::string(episode) + ", people " + (react ? "react" : "do not react") +
                     (published ? "; as published" : "; by default");
        figure.pictures.push_back(to_svg(plot));
      }
    }
  }
  return figure.pictures.empty() ? "" : to_html(figure);
}

}  // namespace bw
