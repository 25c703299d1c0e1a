#include "components/tools/experiments/pf_report.hpp"

#include <cmath>

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json criteria_json(const std::vector<Criterion>& criteria) {
  Json list = Json::array();
  for (const Criterion& c : criteria)
    list.push_back({{"name", c.name}, {"asked", c.asked}, {"measured", number(c.measured)}, {"met", c.met}});
  return list;
}

}  // namespace

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
