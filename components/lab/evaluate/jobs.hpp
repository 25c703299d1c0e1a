// Which drives an evaluation consists of: suites, planners, variants, values and seeds that were asked for,
// in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "components/lab/evaluate/suite.hpp"

namespace bw {

struct EvaluateOptions {
  std::vector<std::string> suites;
  std::vector<std::string> planners = {""};  ///< empty: the graph's own
  std::vector<std::string> set;
  std::string seeds;
  std::string only_episode;
  std::string shard;
  std::string json;
  std::string svg_dir;
  std::string html_dir;
  std::vector<std::string> variants = {""};  ///< empty: the suite as it is
  std::string vary;
  std::string against;
  std::string failures_dir;
  std::vector<std::string> from;  ///< [LABEL:]FILE
  double at_least = 0.0;
  int jobs = 1;  ///< drives at a time, in processes of their own
};

/// One drive still to be done.
struct Job {
  std::size_t suite = 0;
  std::size_t episode = 0;
  std::int64_t seed = 1;
  std::string planner;
  std::string variant;
  std::string value = {};  ///< of the parameter that varies; empty: none does
};

/// A parameter and the values it takes in turn; nothing where none varies.
struct Varied {
  std::string parameter;
  std::vector<std::string> values = {""};
};

/// Of --vary. Throws std::runtime_error that names the option where it has another form, as the next one
/// does.
Varied varied_of(const EvaluateOptions& options);

/// Which part of all jobs: every n-th, so that shards are alike in length.
struct Shard {
  std::int64_t number = 1;
  std::int64_t of = 1;
};
/// Of --shard; the whole where nothing is said.
Shard shard_of(const EvaluateOptions& options);

/// All jobs, in order. At least one.
std::vector<Job> jobs_of(const EvaluateOptions& options, const std::vector<Suite>& suites);
/// Those of a shard.
std::vector<Job> part_of(const std::vector<Job>& jobs, const Shard& shard);

}  // namespace bw
