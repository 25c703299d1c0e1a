#include "tests/components/local_planner/possible/courses.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "components/files/csv_file.hpp"
#include "components/model/random.hpp"
#include "components/program/drive.hpp"
#include "runtime/registry.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/local_planner/possible/course_watch.hpp"

namespace bw {
namespace {

[[maybe_unused]] const bool registered =
    register_component("course_watch", [] { return std::make_unique<CourseWatch>(); });

constexpr double kGap = 2.0 * 0.3 + 0.2;  // [m]
constexpr std::uint64_t kSeed = 2801;
constexpr double kLongest = 90.0;  // [s] of a drive

void add_room(Course& course, double x0, double y0, double x1, double y1) {
  course.walls.insert(
      course.walls.end(),
      {{{x0, y0}, {x1, y0}}, {{x1, y0}, {x1, y1}}, {{x1, y1}, {x0, y1}}, {{x0, y1}, {x0, y0}}});
}

std::string text_of(const std::vector<Segment>& walls) {
  std::string text;
  for (const Segment& wall : walls) {
    text += fmt::format("{}{{x1: {}, y1: {}, x2: {}, y2: {}}}", text.empty() ? "" : ", ", wall.a.x(),
                        wall.a.y(), wall.b.x(), wall.b.y());
  }
  return "[" + text + "]";
}

Graph graph_of(const Course& course, const std::string& planner, Senses senses,
               const std::filesystem::path& posts) {
  const bool own = senses == Senses::own;
  std::vector<std::string> set{
      "world.walls=" + text_of(course.walls),
      "world.track_circles=" + posts.string(),
      fmt::format("world.start={{x: {}, y: {}, theta: {}}}", course.start.x, course.start.y,
                  course.start.theta),
      fmt::format("navigator.goal={{enabled: true, x: {}, y: {}, theta: {}}}", course.goal.x, course.goal.y,
                  course.goal.theta),
      "map_server.area={x: -3.0, y: -6.0, length: 20.0, width: 12.0, resolution: 0.05}",
      "local_planner.algorithm=" + planner,
      fmt::format("people.enabled={}", own),
      fmt::format("ideal_people.enabled={}", senses == Senses::none)};
  if (const char* more = std::getenv("BANDWAGON_SET"); more != nullptr) set.emplace_back(more);
  if (course.walls_are_on_the_map) set.push_back("map_server.walls=" + text_of(course.walls));
  Graph graph = load_graph(std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/map_drive.yaml", set);
  ComponentNode watch{.name = "course_watch", .type = "course_watch"};
  watch.where = graph.components.front().where;
  graph.components.push_back(std::move(watch));
  return graph;
}

}  // namespace

Course gap_course(int number) {
  Random random(kSeed + static_cast<std::uint64_t>(number));
  constexpr double kWall = 4.0;  // x of the wall with the gap
  const double y = random.uniform(-1.2, 1.2);
  const double radius = random.uniform(0.02, 0.1);
  Course course{
      .name = "gap", .walls_are_on_the_map = true, .start = {0.0, 0.0, 0.0}, .goal = {8.0, 0.0, 0.0}};
  course.from = 1.0;
  course.to = 6.5;
  add_room(course, -1.5, -3.0, 9.5, 3.0);
  double upper = y + kGap / 2.0;  // where the wall goes on
  const auto add_post = [&](double px, double py) { course.posts.push_back({{px, py}, radius}); };
  const bool is_pair = number % 2 == 0;
  const double step = random.uniform(0.2, 0.4) + 2.0 * radius;  // between the two of a pair
  const double away = random.uniform(1.0, 1.5) + radius;
  const double aside = random.uniform(-0.4, 0.4);
  switch (number % 3) {
    case 0:
      course.name += " before";
      add_post(kWall - away, y + aside);
      if (is_pair) add_post(kWall - away, y + aside + std::copysign(step, aside));
      break;
    case 1:
      course.name += " beside";
      add_post(kWall, upper + radius);
      if (is_pair) add_post(kWall, upper + radius + step);
      upper += 2.0 * radius + (is_pair ? step : 0.0) + random.uniform(0.0, 0.3);
      break;
    default:
      course.name += " behind";
      add_post(kWall + away, y + aside);
      if (is_pair) add_post(kWall + away, y + aside + std::copysign(step, aside));
  }
  course.walls.push_back({{kWall, -3.0}, {kWall, y - kGap / 2.0}});
  course.walls.push_back({{kWall, upper}, {kWall, 3.0}});
  return course;
}

Course cylinder_course(int number) {
  Random random(kSeed + 1000 + static_cast<std::uint64_t>(number));
  Course course{.name = "cylinders", .start = {0.0, 0.0, 0.0}, .goal = {10.0, 0.0, 0.0}};
  course.from = 0.5;
  course.to = 9.5;
  add_room(course, -1.5, -3.0, 11.5, 3.0);
  constexpr int kTries = 400;
  for (int i = 0; i < kTries; ++i) {
    const double x = random.uniform(1.5, 8.5);
    const double y = random.uniform(-2.9, 2.9);
    const Disc post{{x, y}, random.uniform(0.03, 0.15)};
    const bool is_free = std::all_of(course.posts.begin(), course.posts.end(), [&](const Disc& other) {
      return (other.center - post.center).norm() > other.radius + post.radius + kGap;
    });
    if (is_free) course.posts.push_back(post);
  }
  return course;
}

Course course_of_file(const std::filesystem::path& file) {
  Course course{.name = file.stem().string(), .start = {0.0, 0.0, 0.0}, .goal = {10.0, 0.0, 0.0}};
  course.from = 0.5;
  course.to = 9.0;  // what counts as reached
  // The benchmark drives from (-2.25, 3) along y.
  const Pose2 X_FM{-2.25, 3.0, std::acos(-1.0) / 2.0};
  for (const CsvRow& row : read_csv(file.string(), "x_m,y_m,radius_m"))
    course.posts.push_back({inverse(X_FM) * Vector2(row.values[0], row.values[1]), row.values[2]});
  return course;
}

CourseDrive drive_course(const Course& course, const std::string& planner, Senses senses) {
  const std::filesystem::path posts = scratch_file("posts");
  {
    std::ofstream file(posts);
    file << "x_m,y_m,r_m\n";
    for (const Disc& post : course.posts)
      file << fmt::format("{},{},{}\n", post.center.x(), post.center.y(), post.radius);
  }
  CourseWatch::task = {course.from,
                       course.to,
                       senses == Senses::possible || senses == Senses::person,
                       {},
                       senses == Senses::possible ? 0.49 : 1.0};
  for (const Disc& post : course.posts) CourseWatch::task.phantoms.push_back(post.center);
  DriveSettings settings;
  settings.host.clock = ClockMode::lockstep;
  settings.host.seed = 1;
  settings.longest = Duration::seconds(kLongest);
  const nlohmann::json card = drive(graph_of(course, planner, senses, posts), settings).json;
  std::filesystem::remove(posts);
  const CourseSeen& seen = CourseWatch::seen;
  CourseDrive result{.reached = card.value("reached", false),
                     .collisions = card.value("collisions_at_speed", 0),
                     .most_confident = seen.most_confident,
                     .confirmed = static_cast<double>(seen.confirmed) / std::max(1, seen.messages)};
  if (seen.left >= seen.entered) result.time = seen.left - seen.entered;
  return result;
}

}  // namespace bw
