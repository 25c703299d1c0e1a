// Predictions on recorded people who were not trained on: negative log-likelihood, error, and the ellipses' honesty.
#pragma once

#include <vector>

#include "components/model/obstacles.hpp"
#include "components/people/prediction/predictor.hpp"
#include "components/world/replayed_people.hpp"

namespace bw::people {

struct Judging {
  std::vector<double> times{1.0, 2.0, 3.0, 4.0};  ///< [s] ahead, multiples of the predictor's step
  double noise = 0.0;  ///< [m] added to annotations; the same draws for every predictor
  StaticObstacles walls{};
};

/// At one time ahead; means.
struct PredictionVerdict {
  double loss = 0.0;    ///< [nats] negative log-likelihood
  double error = 0.0;   ///< [m]
  double inside = 0.0;  ///< share of truths inside the 95 % ellipse
  int count = 0;
};

/// Each track followed by the filter of the reference figures (experiments/protocols.md 8.7: constant velocity, measurement
/// noise 0.05 m, white acceleration 0.3 m^2/s^3); from 3.2 s on each annotation is predicted from, and the truth is the
/// annotations without noise, linear between two. A verdict for each of `times`.
std::vector<PredictionVerdict> judge_prediction(const std::vector<Track>& tracks, Predictor predictor,
                                                const Judging& how);

}  // namespace bw::people
