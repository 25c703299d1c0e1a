#include "components/people/detector/classifier.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

#include "components/people/detector/classifier_table.inc"

}  // namespace

double probability(std::span<const DecisionTree> trees, float bias, const Features& features) {
  return 1.0 / (1.0 + std::exp(-static_cast<double>(log_odds(trees, bias, features.values))));
}

HumanScores at_even_odds(const HumanScores& trained, double human) {
  const double weight = (1.0 - human) / human;
  const double both = weight * (trained.leg + trained.body);
  const double sum = both + std::max(0.0, 1.0 - trained.leg - trained.body);
  return {weight * trained.leg / sum, weight * trained.body / sum};
}

HumanScores classify(const Features& features) {
  return at_even_odds(
      {probability(kLegTrees, kLegBias, features), probability(kBodyTrees, kBodyBias, features)},
      kHumanShare);
}

}  // namespace bw::people
