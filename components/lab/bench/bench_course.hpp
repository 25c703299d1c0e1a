// `bandwagon bench course`: whole robots through fields of cylinders without a map, scored as the BARN
// benchmark does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/evaluation/success.hpp"
#include "components/lab/bench/course_world.hpp"

namespace bw {

struct BenchCourseArguments {
  std::string graph = "course";
  std::string worlds;            ///< folder of worlds, one CSV x_m,y_m,radius_m each; empty: none
  std::string only;              ///< those whose name begins so; empty: all
  int generate = 0;              ///< this many of course_generator.hpp beside them
  std::uint64_t first_seed = 1;  ///< of the generated ones
  std::vector<std::string> planners = {"eteb"};
  std::vector<std::string> set;  ///< component.param=value
  std::string svg;               ///< folder for a picture of each drive; empty: none
  std::string json;              ///< output file; empty: none
};

/// One course to drive.
struct Course {
  CourseWorld world;
  CourseMeasures measures;
  bool generated = false;  ///< from a seed; else one of a folder
};

/// What came of it.
struct CourseOutcome {
  std::string name;
  bool reached = false;  ///< within kCourseReached of the goal in time
  double least_gap =
      0.0;  ///< between outline and cylinders, at ten looks a second until then [m]; negative: overlapping
  int contacts = 0;         ///< with cylinders, of the whole drive
  double time = 0.0;        ///< until it was there, or was given up [s]
  double best_time = 0.0;   ///< OT: the shortest path at 2 m/s [s]
  double score = 0.0;       ///< success OT / clip(time, 2 OT, 8 OT)
  double mean_cycle = 0.0;  ///< CPU of a planning cycle [ms]
  std::string reason;       ///< what the navigator said
  std::string samples_sha256;

  bool success() const { return is_success(reached, contacts); }
};

inline constexpr double kCourseSpeed = 2.0;    ///< [m/s]
inline constexpr double kCourseLimit = 100.0;  ///< [s]

/// Of a drive that took `time` [s] where `best_time` is the best: 0.5 at most, for up to twice that.
double course_score(bool success, double time, double best_time);

/// Worlds of a folder in the order of their names, in map. Throws std::runtime_error without any, and for
/// what cannot be read.
std::vector<CourseWorld> read_courses(const std::string& folder);

/// One drive in lock-step. Throws ConfigError or std::runtime_error.
CourseOutcome drive_course(const Course& course, const std::string& planner,
                           const BenchCourseArguments& arguments);

/// Prints the courses, a line for each drive and the means; writes JSON, given and generated courses as suites of their own, and
/// pictures. Returns the exit status
/// (0). Throws std::runtime_error on unusable files or names.
int bench_course(const BenchCourseArguments& arguments);

}  // namespace bw
