#include "components/local_planner/dwa/sample_score.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace bw::dwa {

std::vector<double> normalised(std::vector<double> column, Normalisation how, double scale) {
  if (column.empty()) return column;
  double low = 0.0;
  double span = scale;
  if (how == Normalisation::sum) span = std::accumulate(column.begin(), column.end(), 0.0);
  if (how == Normalisation::minmax) {
    const auto [min, max] = std::minmax_element(column.begin(), column.end());
    low = *min;
    span = *max - *min;
  }
  for (double& value : column) value = span > 0.0 ? (value - low) / span : 0.0;
  return column;
}

std::vector<double> objective(const ScoreColumns& columns, const ScoreWeights& weights, Normalisation how,
                              const ScoreScales& scales) {
  const std::vector<double> heading = normalised(columns.heading, how, std::numbers::pi);
  const std::vector<double> clearance = normalised(columns.clearance, how, scales.clearance);
  const std::vector<double> velocity = normalised(columns.velocity, how, scales.velocity);
  std::vector<double> score(heading.size());
  for (std::size_t i = 0; i < score.size(); ++i) {
    score[i] =
        weights.heading * heading[i] + weights.clearance * clearance[i] + weights.velocity * velocity[i];
  }
  return score;
}

}  // namespace bw::dwa
