#include "components/lab/bench/bench_course.hpp"

#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/course_generator.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Course> courses_of(const BenchCourseArguments& arguments) {
  std::vector<Course> courses;
  if (!arguments.worlds.empty()) {
    for (CourseWorld& world : read_courses(arguments.worlds)) {
      const CourseMeasures measures = measure(world);
      courses.push_back({std::move(world), measures});
    }
  }
  for (int i = 0; i < arguments.generate; ++i) {
    GeneratedCourse drawn = generate_course(arguments.first_seed + static_cast<std::uint64_t>(i));
    courses.push_back({std::move(drawn.world), drawn.measures, true});
  }
  std::erase_if(courses,
                [&](const Course& course) { return !course.world.name.starts_with(arguments.only); });
  if (courses.empty()) throw std::runtime_error("no course: name a folder of --worlds or --generate some");
  return courses;
}

void print_range(const char* what, const std::vector<Course>& courses) {
  std::vector<CourseMeasures> measures;
  for (const Course& course : courses) measures.push_back(course.measures);
  const CourseRanges ranges = ranges_of(measures);
  std::printf(
      "%s",
      fmt::format(
          "{}: filled {:.3f} to {:.3f}, clearance along the shortest way {:.2f} to {:.2f} m, widest way's "
          "narrowest place {:.2f} to {:.2f} m from a cylinder, way {:.2f} to {:.2f} m\n",
          what, ranges.least.filled, ranges.most.filled, ranges.least.clearance, ranges.most.clearance,
          ranges.least.narrowest, ranges.most.narrowest, ranges.least.path_length, ranges.most.path_length)
          .c_str());
}

void print(const Course& course, const CourseOutcome& outcome) {
  std::printf(
      "%s",
      fmt::format(
          "{:10} filled {:.3f} clearance {:.2f} narrowest {:.2f} way {:5.2f}  {:8} {:6.2f} s gap {:.3f} m score {:.3f} {}\n",
          outcome.name, course.measures.filled, course.measures.clearance, course.measures.narrowest,
          course.measures.path_length,
          !outcome.reached       ? "failed"
          : outcome.contacts > 0 ? "contact"
                                 : "reached",
          outcome.time, outcome.least_gap, outcome.score, outcome.success() ? "" : outcome.reason)
          .c_str());
  std::fflush(stdout);
}

Json to_json(const Course& course, const CourseOutcome& outcome) {
  return {{"name", outcome.name},
          {"filled", course.measures.filled},
          {"clearance_m", course.measures.clearance},
          {"narrowest_m", course.measures.narrowest},
          {"way_m", course.measures.path_length},
          {"success", outcome.success()},
          {"reached", outcome.reached},
          {"contacts", outcome.contacts},
          {"least_gap_m", outcome.least_gap},
          {"time_s", outcome.time},
          {"best_time_s", outcome.best_time},
          {"score", outcome.score},
          {"mean_ms", outcome.mean_cycle},
          {"reason", outcome.reason},
          {"samples_sha256", outcome.samples_sha256}};
}

Json summary_of(const std::string& row, const std::vector<CourseOutcome>& outcomes) {
  int successes = 0;
  int contacts = 0;
  std::vector<double> times;
  std::vector<double> scores;
  for (const CourseOutcome& outcome : outcomes) {
    scores.push_back(outcome.score);
    contacts += outcome.contacts > 0 ? 1 : 0;
    if (!outcome.success()) continue;
    ++successes;
    times.push_back(outcome.time);
  }
  const int count = static_cast<int>(outcomes.size());
  const Interval share = wilson95(successes, count);
  std::printf(
      "%s", fmt::format(
                "{}: {} of {} ({:.2f} to {:.2f}), {} with contacts, mean time {:.2f} s, mean score {:.3f}\n",
                row, successes, count, share.low, share.high, contacts, mean(times), mean(scores))
                .c_str());
  return {{"courses", count},          {"success_means", kSuccessMeans}, {"successes", successes},
          {"with_contacts", contacts}, {"mean_time_s", mean(times)},     {"mean_score", mean(scores)}};
}

}  // namespace

int bench_course(const BenchCourseArguments& arguments) {
  if (arguments.planners.empty()) throw std::runtime_error("a planner must be named");
  const std::vector<Course> courses = courses_of(arguments);
  const CourseRanges given = given_ranges();
  std::printf(
      "%s",
      fmt::format(
          "given worlds span: filled {:.3f} to {:.3f}, clearance {:.2f} to {:.2f} m, narrowest {:.2f} to {:.2f} m\n",
          given.least.filled, given.most.filled, given.least.clearance, given.most.clearance,
          given.least.narrowest, given.most.narrowest)
          .c_str());
  print_range("these courses span", courses);
  Json rows = Json::array();
  for (const std::string& planner : arguments.planners) {
    for (const bool generated : {false, true}) {
      const std::string set = generated ? "BARN, generated worlds" : "BARN, given worlds";
      std::vector<CourseOutcome> outcomes;
      Json drives = Json::array();
      for (const Course& course : courses) {
        if (course.generated != generated) continue;
        outcomes.push_back(drive_course(course, planner, arguments));
        print(course, outcomes.back());
        drives.push_back(to_json(course, outcomes.back()));
      }
      if (outcomes.empty()) continue;
      rows.push_back({{"set", set},
                      {"planner", planner},
                      {"drives", std::move(drives)},
                      {"summary", summary_of(fmt::format("{}, {}", set, planner), outcomes)}});
      write_json(arguments.json, {{"whole_graph", true}, {"rows", rows}});
    }
  }
  return 0;
}

}  // namespace bw
