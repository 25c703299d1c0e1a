#include "components/lab/experiments/anticipation_report.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Criterion> criteria(const AnticipationResults& results, const std::string& suffix) {
  std::vector<std::string> order = {"teb" + suffix, "pteb" + suffix};
  if (results.subject == "eteb") order.push_back("eteb" + suffix);
  std::vector<Criterion> all;
  for (std::size_t i = 1; i < order.size(); ++i) {
    for (Criterion& c : crossing_criteria(results.crossing, order[i], order[0])) all.push_back(std::move(c));
  }
  for (Criterion& c : hallway_criteria(hallway_rows(results.hallway), order)) all.push_back(std::move(c));
  return all;
}

}  // namespace

std::vector<Criterion> anticipation_criteria(const AnticipationResults& results) {
  return criteria(results, "");
}

std::vector<Criterion> published_criteria(const AnticipationResults& results) {
  return criteria(results, ", published");
}

nlohmann::ordered_json anticipation_json(const AnticipationResults& results) {
  return {{"experiment", results.subject},
          {"criteria", criteria_json(anticipation_criteria(results))},
          {"criteria_as_published", criteria_json(published_criteria(results))},
          {"crossing", crossing_json(results.geometry, results.crossing)},
          {"crossing_as_proposed", crossing_json(proposed_crossing(), results.proposed)},
          {"hallway", hallway_json(results.hallway)}};
}

}  // namespace bw
