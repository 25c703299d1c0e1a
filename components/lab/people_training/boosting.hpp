// Gradient boosting of small trees for two classes (Friedman 2001, with second-order leaves as Chen and
// Guestrin 2016): logistic loss, thresholds at quantiles, no randomness.
#pragma once

#include <span>
#include <vector>

#include "components/people/decision_tree.hpp"

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

/// Feature values of samples, one sample after the other.
struct FeatureRows {
  std::size_t features = 0;  ///< of each sample
  std::vector<float> values;

  std::size_t samples() const { return values.size() / features; }
  std::span<const float> operator[](std::size_t i) const {
    return std::span(values).subspan(i * features, features);
  }
};

/// `positive` holds a flag for each of `rows`. All numbers are rounded to five digits, as they will be
/// printed.
BoostedTrees boost(const FeatureRows& rows, std::span<const std::uint8_t> positive,
                   const BoostingOptions& options);

}  // namespace bw::people
