// Gradient boosting of small trees for two classes (Friedman 2001, with second-order leaves as Chen and
// Guestrin 2016): logistic loss, thresholds at quantiles, no randomness.
#pragma once

#include <span>
#include <vector>

#include "components/people/detector/classifier.hpp"

namespace bw::people {

struct BoostingOptions {
  int trees = 80;
  double rate = 0.2;       ///< share of each tree that is added
  double smoothing = 5.0;  ///< added to the second derivatives of a leaf
  int thresholds = 63;     ///< tried for each feature
};

struct BoostedTrees {
  float bias = 0.0F;
  std::vector<DecisionTree> trees;
};

/// `positive` holds a flag for each of `features`. All numbers are rounded to five digits, as they will be
/// printed.
BoostedTrees boost(std::span<const Features> features, std::span<const std::uint8_t> positive,
                   const BoostingOptions& options);

}  // namespace bw::people
