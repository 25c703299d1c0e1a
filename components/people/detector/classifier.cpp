#include "components/people/detector/classifier.hpp"

#include <cmath>

namespace bw::people {
namespace {

#include "components/people/detector/classifier_table.inc"

}  // namespace

double probability(std::span<const DecisionTree> trees, float bias, const Features& features) {
  float sum = bias;
  for (const DecisionTree& tree : trees) sum += tree.evaluate(features);
  return 1.0 / (1.0 + std::exp(-static_cast<double>(sum)));
}

HumanScores classify(const Features& features) {
  return {probability(kLegTrees, kLegBias, features), probability(kBodyTrees, kBodyBias, features)};
}

}  // namespace bw::people
