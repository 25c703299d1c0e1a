// The objective (3.1), G = alpha head + beta dist + gamma vel, over the admissible samples.
#pragma once

#include <vector>

#include "components/local_planner/dwa/dwa_options.hpp"

namespace bw::dwa {

/// A column without sum or range becomes zeros: it tells the samples nothing.
std::vector<double> normalised(std::vector<double> column, Normalisation how, double scale);

/// One value per sample and column, each the larger the better.
struct ScoreColumns {
  std::vector<double> heading;    ///< pi less the heading error [rad]
  std::vector<double> clearance;  ///< [m], capped
  std::vector<double> velocity;   ///< [m/s]
};

struct ScoreScales {
  double clearance = 3.0;  ///< [m]
  double velocity = 1.0;   ///< [m/s]
};

/// G of every sample. The heading's scale is pi.
std::vector<double> objective(const ScoreColumns& columns, const ScoreWeights& weights, Normalisation how,
                              const ScoreScales& scales);

}  // namespace bw::dwa
