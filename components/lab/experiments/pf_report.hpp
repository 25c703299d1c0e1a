// What `bandwagon reproduce pf` writes: the figures as JSON, and a page with the published values beside
// them.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "components/lab/experiments/pf_experiment.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

/// {experiment, seeds, particles, rows: [{row, published: {encoder, proposed}, cells: [{method, mean, q05,
/// q95, per_seed}]}], criteria: [{name, asked, measured, met}], criteria_printed: [...]}.
nlohmann::ordered_json pf_json(const PfTable& table);

/// What the page shows.
report::Document pf_page(const PfTable& table);

}  // namespace bw
