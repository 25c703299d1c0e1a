// What E5 shows (protocols.md 8.5), in words and numbers.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/lab/experiments/criterion.hpp"
#include "components/lab/experiments/crossing_experiment.hpp"

namespace bw {

/// TEB with people known to move, TEB in several topologies, PTEB and, `with_eteb`, ETEB: as they drive by
/// default.
std::vector<CrossingEntry> default_entries(bool with_eteb);

/// The same as published: TEB and PTEB take people as standing, ETEB has them doubled (teb/theory.md 6.5,
/// D10).
std::vector<CrossingEntry> published_entries(bool with_eteb);

/// Of `planner` against `reference`, both by label among `results`: passes behind A more often, touches
/// nobody, keeps a lower collision index. Throws std::out_of_range when one of them is missing.
std::vector<Criterion> crossing_criteria(const std::vector<CrossingResult>& results,
                                         const std::string& planner, const std::string& reference);

/// {geometry, rows: [{label, planner, set, runs, ..., per_seed}]}
nlohmann::ordered_json crossing_json(const CrossingGeometry& geometry,
                                     const std::vector<CrossingResult>& results);

/// One line per row below a head.
std::string crossing_table(const std::vector<CrossingResult>& results);

}  // namespace bw
