// Is this outline one leg, two legs in one, or neither: two sums of small decision trees (gradient boosting,
// Friedman 2001, logistic loss), trained on our own world by components/lab/people_training/.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "components/people/detector/features.hpp"

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

  float evaluate(const Features& f) const {
    int node = 0;
    for (int depth = 0; depth < kDepth; ++depth) {
      const auto n = static_cast<std::size_t>(node);
      node = 2 * node + (f.values[feature[n]] < threshold[n] ? 1 : 2);
    }
    return leaf[static_cast<std::size_t>(node - kNodes)];
  }
};

/// Which share of outlines that look like this one is human, where as many human outlines are about as
/// others. So leg + body, at most 1, is the probability of a human where nothing is known, and its log odds
/// are what the look adds to what is known. Looks at one thing a short time apart say nearly the same: they
/// must not all be added.
struct HumanScores {
  double leg = 0.0;   ///< of one leg
  double body = 0.0;  ///< of two legs of one person in one outline
};

/// 1 / (1 + exp(-(bias + sum of the trees))).
double probability(std::span<const DecisionTree> trees, float bias, const Features& features);

/// `trained`: shares among outlines of which a share of `human` are legs and bodies.
HumanScores at_even_odds(const HumanScores& trained, double human);

/// In rooms like those trained on; how far a score is from the share it says: classifier_report.txt.
HumanScores classify(const Features& features);

/// Wider outlines are nobody: not asked, not trained on [m].
inline constexpr double kWidestPerson = 0.9;

}  // namespace bw::people
