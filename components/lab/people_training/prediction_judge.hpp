// Negative log-likelihood of predictions on recorded people who were not trained on.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "components/people/prediction/predictor.hpp"
#include "components/world/replayed_people.hpp"

namespace bw::people {

/// At 1, 2, 3 and 4 s.
struct PredictionVerdict {
  std::array<double, 4> loss{};    ///< [nats] negative log-likelihood, mean
  std::array<double, 4> error{};   ///< [m] mean
  std::array<double, 4> inside{};  ///< share of truths inside the 95 % ellipse
  std::array<int, 4> count{};
};

/// Each track followed by the WalkerFilter, its annotations with `noise` [m] of a tracker added (the same draws for every
/// model); from 3.2 s on each annotation is predicted from, and the truth is the annotations without noise, linear between
/// two. By `head`, or by `options` alone.
PredictionVerdict judge_prediction(const std::vector<Track>& tracks, double noise, PredictionOptions options,
                                   const std::optional<HeadWeights>& head);

}  // namespace bw::people
