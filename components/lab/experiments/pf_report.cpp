#include "components/lab/experiments/pf_report.hpp"

namespace bw {

using Json = nlohmann::ordered_json;

nlohmann::ordered_json pf_json(const PfTable& table) {
  Json rows = Json::array();
  for (std::size_t row = 0; row < kPfRows.size(); ++row) {
    Json cells = Json::array();
    for (const PfCell& cell : table.cells[row]) {
      cells.push_back({{"method", to_string(cell.method)},
                       {"mean_m", cell.mean},
                       {"q05_m", cell.low},
                       {"q95_m", cell.high},
                       {"per_seed_m", cell.errors}});
    }
    rows.push_back(
        {{"row", kPfRows[row].name},
         {"published_m",
          {{"encoder", kPfRows[row].published_encoder}, {"proposed", kPfRows[row].published_proposed}}},
         {"cells", cells}});
  }
  return {{"experiment", "pf"},
          {"seeds", {table.options.first_seed, table.options.last_seed}},
          {"particles", table.options.particles},
          {"rows", rows},
          {"criteria", criteria_json(table.criteria)},
          {"criteria_printed", criteria_json(pf_criteria(table, PfMethod::printed))}};
}

}  // namespace bw
