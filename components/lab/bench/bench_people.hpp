// `bandwagon bench people`: people tracked again in a recording, by the component that drives, and scored.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/people/score/stretch_score.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw {

struct BenchPeopleArguments {
  std::string bag;                  ///< file or folder
  std::vector<std::string> labels;  ///< CSV files, each a stretch of its own
  bool with_truth = true;        ///< without labels, the truth of a simulated world counts if the bag has it
  std::string graph;             ///< empty: a component `people` with its defaults
  std::string component;         ///< name in the graph; empty: the one of type people
  std::vector<std::string> set;  ///< component.param=value
  std::string scan;              ///< topic; empty: the component's, or the only one
  std::string odom;              ///< likewise
  bool is_standing = false;      ///< the robot does not move: no odometry is needed
  double range = 6.0;            ///< of people who count, from the laser, where the truth is the world's [m]
  people::StretchOptions scoring;
  bool show_errors = false;  ///< prints every one
  std::string json;          ///< output file; empty: none
  std::string page;          ///< output file; empty: none
};

/// A stretch with its labels, in odom; times since the first scan [s].
struct LabelledStretch {
  std::string name;
  std::vector<people::LabelledInstant> labels;
  people::StretchScore score;
};

/// What came of a bag.
struct PeopleRun {
  std::string bag;
  std::size_t scans = 0;                      ///< in the bag
  double duration = 0.0;                      ///< from the first scan to the last that was looked at [s]
  std::vector<people::TrackedSweep> sweeps;   ///< of scans that were looked at
  std::vector<std::optional<Vector2>> robot;  ///< at each sweep, in odom
  std::vector<LabelledStretch> stretches;
  bool is_truth = false;           ///< the labels are the world's truth
  std::vector<std::string> notes;  ///< what limits all this
};

/// `recording` in place of arguments.bag, which names it. Throws ConfigError or std::runtime_error: unusable
/// files, topics, labels or parameters.
PeopleRun run_people(const bag::Bag& recording, const BenchPeopleArguments& arguments);

/// Prints figures, writes JSON and page. Returns the exit status (0). Throws as run_people, and for what is
/// no bag.
int bench_people(const BenchPeopleArguments& arguments);

}  // namespace bw
