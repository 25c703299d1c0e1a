// Under what a row of a bench was measured: the figures of two planners mean something only beside these.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "components/lab/bench/bench.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/model/limits.hpp"

namespace bw {

struct BenchConditions {
  BenchWeights weights = BenchWeights::defaults;
  PlannerOptions options;
  Limits limits;
  int max_iterations = 0;  ///< of a cycle, over all candidates
};

/// {weights_set, weights, budget, limits, layers}.
nlohmann::ordered_json to_json(const BenchConditions& conditions);

/// The same without the single weights, for people.
std::string in_a_line(const BenchConditions& conditions);

/// "file" or "default".
const char* name_of(BenchWeights weights);

}  // namespace bw
