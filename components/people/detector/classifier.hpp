// Is this outline one leg, two legs in one, or neither: two sums of small decision trees (gradient boosting,
// Friedman 2001, logistic loss), trained on our own world by components/lab/people_training/.
#pragma once

#include <span>

#include "components/people/decision_tree.hpp"
#include "components/people/detector/features.hpp"

namespace bw::people {

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
