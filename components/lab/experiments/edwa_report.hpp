// What `bandwagon reproduce edwa` writes: the figures as JSON, and a page with the published values beside
// them.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/lab/experiments/edwa_experiment.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

/// The experiment under one reading of the source.
struct EdwaVariant {
  std::string name;
  std::string meaning;  ///< one sentence
  EdwaExperimentOptions options;
};

/// The default reading (protocols.md 8.3) first; then what drives a robot here, and the literal readings.
std::vector<EdwaVariant> edwa_variants(std::uint64_t first_seed, std::uint64_t last_seed);

struct EdwaResult {
  EdwaVariant variant;
  EdwaTable table;
};

/// {experiment, seeds, rows: [{scene, pairing, published, mean, sd, runs, success, contacts, timeouts, ...}],
/// criteria: [{name, asked, measured, met}], variants: [{name, meaning, rows, criteria}]}: rows and criteria
/// of the first result, variants the others. What is not a number (a mean of no run) is null.
nlohmann::ordered_json edwa_json(const std::vector<EdwaResult>& results);

/// What the page shows: first result in full with courses of its first seed, then the others.
report::Document edwa_page(const std::vector<EdwaResult>& results);

}  // namespace bw
