// What every subject of `bandwagon reproduce` leaves behind, in one form.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/lab/experiments/criterion.hpp"
#include "components/lab/experiments/published_value.hpp"
#include "components/lab/experiments/reproduce.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

struct ReproduceReport {
  std::string subject;
  std::string judged;               ///< what the exit status stands for
  std::vector<Criterion> criteria;  ///< of it
  std::vector<PublishedValue> published;
  nlohmann::ordered_json results;  ///< the subject's own
  report::Document page;
  /// The same asked of other readings of the source: decides nothing.
  std::vector<std::pair<std::string, std::vector<Criterion>>> other_readings = {};
};

/// Of what a part of `reproduce all` is made, besides files that it reads: {program, cpu, quick}.
nlohmann::ordered_json made_by(const ReproduceArguments& arguments);

/// The document as DIR/index.html; a program without the page says that there is none.
void write_page(const report::Document& page, const ReproduceArguments& arguments);

/// Writes index.html, then results.json: what the subject found, and `judged`, `criteria`, `other_readings`,
/// `published`, `tuned_to_published`, `made_by`. Prints the last lines of the summary. Returns whether all
/// that is judged is met.
bool write_report(const ReproduceReport& report, const ReproduceArguments& arguments);

}  // namespace bw
