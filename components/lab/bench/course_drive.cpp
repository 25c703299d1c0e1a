#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "components/files/csv_file.hpp"
#include "components/lab/bench/bench_course.hpp"
#include "components/lab/bench/shapes_file.hpp"
#include "components/model/footprint_distance.hpp"
#include "components/program/drive.hpp"
#include "runtime/parameters/overrides.hpp"

namespace bw {
namespace {

std::string rows_of(const CourseWorld& world) {
  std::string rows = "x_m,y_m,r_m\n";
  for (const Disc& post : world.posts)
    rows += fmt::format("{},{},{}\n", post.center.x(), post.center.y(), post.radius);
  return rows;
}

/// When the robot was first so near to the goal [s since the start of the drive]: between two moments, at the
/// share of the distance.
std::optional<double> time_of_arrival(const RunRecording& course) {
  const Vector2 goal(kCourseLength, 0.0);
  double before = 0.0;
  for (std::size_t i = 0; i < course.moments.size(); ++i) {
    const double distance = (course.moments[i].X_MB.position() - goal).norm();
    if (distance <= kCourseReached) {
      if (i == 0) return course.moments[i].time;
      const double share = (before - kCourseReached) / (before - distance);
      return std::lerp(course.moments[i - 1].time, course.moments[i].time, share);
    }
    before = distance;
  }
  return std::nullopt;
}

// Reckoned from the path that was driven, beside the contacts that the world counts.
double least_gap(const RunRecording& course, const CourseWorld& world, double until) {
  double least = std::numeric_limits<double>::infinity();
  for (const RecordedMoment& moment : course.moments) {
    if (moment.time > until) break;
    for (const Disc& post : world.posts)
      least =
          std::min(least, gap_to(course.robot, moment.X_MB, {post.center, post.center, post.radius}, least));
  }
  return least;
}

}  // namespace

double course_score(bool success, double time, double best_time) {
  return success ? best_time / std::clamp(time, 2.0 * best_time, 8.0 * best_time) : 0.0;
}

std::vector<CourseWorld> read_courses(const std::string& folder) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".csv") files.insert(entry.path());
  }
  if (files.empty()) throw std::runtime_error(folder + ": holds no world (*.csv)");
  // The benchmark drives from (-2.25, 3) along y.
  const Pose2 X_FM{-2.25, 3.0, std::numbers::pi / 2.0};
  std::vector<CourseWorld> worlds;
  for (const std::filesystem::path& file : files) {
    worlds.push_back({.name = file.stem().string(), .posts = {}});
    for (const CsvRow& row : read_csv(file.string(), "x_m,y_m,radius_m"))
      worlds.back().posts.push_back({inverse(X_FM) * Vector2(row.values[0], row.values[1]), row.values[2]});
  }
  return worlds;
}

CourseOutcome drive_course(const Course& course, const std::string& planner,
                           const BenchCourseArguments& arguments) {
  const ShapesFile posts("course", rows_of(course.world));
  Graph graph = load_graph(arguments.graph, arguments.set);
  apply_override(graph, parse_override("world.track_circles=" + posts.path().string()));
  apply_override(graph, parse_override("local_planner.algorithm=" + planner));
  DriveSettings settings;
  settings.host.clock = ClockMode::lockstep;
  settings.host.alone = true;
  settings.host.seed = 1;
  settings.longest = Duration::seconds(kCourseLimit);
  settings.course = true;
  if (!arguments.svg.empty()) {
    std::filesystem::create_directories(arguments.svg);
    std::string name = course.world.name + "_" + planner;
    std::replace(name.begin(), name.end(), ' ', '_');
    settings.svg = std::filesystem::path(arguments.svg) / (name + ".svg");
  }
  const DriveResult result = drive(std::move(graph), settings);
  CourseOutcome outcome{.name = course.world.name, .time = kCourseLimit};
  outcome.best_time = course.measures.path_length / kCourseSpeed;
  outcome.contacts = result.json.value("collisions", 0);
  outcome.reason = result.json.value("reason", "");
  outcome.samples_sha256 = result.json.value("samples_sha256", "");
  if (result.json["planner"].is_object()) outcome.mean_cycle = result.json["planner"].value("mean_ms", 0.0);
  const std::optional<double> arrival = result.course ? time_of_arrival(*result.course) : std::nullopt;
  outcome.reached = arrival.has_value();
  if (arrival) outcome.time = *arrival;
  if (result.course) outcome.least_gap = least_gap(*result.course, course.world, outcome.time);
  outcome.score = course_score(outcome.success(), outcome.time, outcome.best_time);
  return outcome;
}

}  // namespace bw
