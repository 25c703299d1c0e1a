#include "components/lab/experiments/edwa_criteria.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bw {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const EdwaRow& row_of(const std::vector<EdwaRow>& rows, int scene, std::string_view robot,
                      std::string_view others) {
  return *std::find_if(rows.begin(), rows.end(), [&](const EdwaRow& row) {
    return row.scene == scene && row.pairing.robot == robot && row.pairing.others == others;
  });
}

}  // namespace

std::vector<Criterion> edwa_criteria(const std::vector<EdwaRow>& rows) {
  double largest_deviation = 0.0;
  double contacts = 0.0;
  double missed = 0.0;
  double lowest_v = kInfinity;
  for (const EdwaRow& row : rows) {
    if (row.pairing.robot != "edwa") continue;
    const double deviation = std::abs(row.mean - row.published);
    largest_deviation = std::max(largest_deviation, std::isnan(deviation) ? kInfinity : deviation);
    contacts += row.contacts;
    missed += static_cast<double>(row.runs.size()) - row.success;
    lowest_v = std::min(lowest_v, row.lowest_v);
  }
  double smallest_gain = kInfinity;
  double largest_delta_change = -kInfinity;
  for (int scene = 0; scene < kEdwaScenes; ++scene) {
    const EdwaRow& dwa = row_of(rows, scene, "dwa", "dwa");
    const EdwaRow& edwa = row_of(rows, scene, "edwa", "dwa");
    const double gain = edwa.mean - dwa.mean;
    smallest_gain = std::min(smallest_gain, std::isnan(gain) ? -kInfinity : gain);
    if (scene == 0) continue;  // head-on: not asked for
    largest_delta_change = std::max(largest_delta_change, edwa.mean_max_delta - dwa.mean_max_delta);
  }
  const std::size_t seeds = rows.front().runs.size();
  const auto of_means = [&](Criterion c) { return over_seeds(std::move(c), seeds, kEdwaSeeds); };
  return {
      of_means({"largest deviation of an EDWA row from Table 3.2 [m/s]", "<= 0.04", largest_deviation,
                largest_deviation <= 0.04}),
      of_means({"smallest gain of EDWA-DWA over DWA-DWA in a scene [m/s]", ">= 0.01", smallest_gain,
                smallest_gain >= 0.01}),
      {"contacts of EDWA robots", "0", contacts, contacts == 0.0},
      {"EDWA runs that did not reach the goal", "0", missed, missed == 0.0},
      of_means({"S2 to S4: largest change of the mean largest delta_min, EDWA-DWA less DWA-DWA", "< 0",
                largest_delta_change, largest_delta_change < 0.0}),
      {"lowest speed of an EDWA robot under way [m/s]", ">= 0.4", lowest_v, lowest_v >= 0.4},
  };
}

}  // namespace bw
