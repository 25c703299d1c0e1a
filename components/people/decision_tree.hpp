// Small decision trees whose sum is a log odds: gradient boosting (Friedman 2001, logistic loss), trained by
// components/lab/people_training/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace bw::people {

/// A full tree of three questions. Node n asks "value of feature[n] < threshold[n]"; yes goes to node 2n + 1,
/// no to 2n + 2; below the last row come the leaves, from left to right.
struct DecisionTree {
  static constexpr int kDepth = 3;
  static constexpr int kNodes = (1 << kDepth) - 1;
  static constexpr int kLeaves = 1 << kDepth;

  std::array<std::uint8_t, kNodes> feature{};
  std::array<float, kNodes> threshold{};
  std::array<float, kLeaves> leaf{};

  float evaluate(std::span<const float> features) const {
    int node = 0;
    for (int depth = 0; depth < kDepth; ++depth) {
      const auto n = static_cast<std::size_t>(node);
      // No branch: nothing foretells which way it goes.
      node = 2 * node + 2 - static_cast<int>(features[feature[n]] < threshold[n]);
    }
    return leaf[static_cast<std::size_t>(node - kNodes)];
  }
};

/// The bias and the sum of the trees.
inline float log_odds(std::span<const DecisionTree> trees, float bias, std::span<const float> features) {
  float sum = bias;
  for (const DecisionTree& tree : trees) sum += tree.evaluate(features);
  return sum;
}

}  // namespace bw::people
