#include "components/lab/people_training/boosting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace bw::people {
namespace {

constexpr float kNever = -1e30F;  // a threshold that parts nothing: all go to the right

float rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return std::strtof(text, nullptr);
}

struct Gradient {
  double first = 0.0;
  double second = 0.0;

  void operator+=(const Gradient& other) {
    first += other.first;
    second += other.second;
  }
  Gradient minus(const Gradient& other) const { return {first - other.first, second - other.second}; }
  double gain(double smoothing) const { return first * first / (second + smoothing); }
};

/// Every feature value as the number of thresholds that it reaches.
class Bins {
 public:
  Bins(const FeatureRows& rows, int thresholds) : cuts_(rows.features), bins_(rows.features) {
    const std::size_t samples = rows.samples();
    std::vector<float> values(samples);
    for (std::size_t f = 0; f < rows.features; ++f) {
      for (std::size_t i = 0; i < samples; ++i) values[i] = rows[i][f];
      std::sort(values.begin(), values.end());
      auto& cuts = cuts_[f];
      for (int t = 1; t <= thresholds; ++t) {
        const auto at = static_cast<std::size_t>(t) * samples / static_cast<std::size_t>(thresholds + 1);
        const float cut = rounded(values[at]);
        if (cut > values.front() && (cuts.empty() || cut > cuts.back())) cuts.push_back(cut);
      }
      bins_[f].resize(samples);
      for (std::size_t i = 0; i < samples; ++i) {
        const float value = rows[i][f];
        bins_[f][i] =
            static_cast<std::uint8_t>(std::upper_bound(cuts.begin(), cuts.end(), value) - cuts.begin());
      }
    }
  }

  std::size_t features() const { return cuts_.size(); }
  const std::vector<float>& cuts(std::size_t feature) const { return cuts_[feature]; }
  const std::vector<std::uint8_t>& of(std::size_t feature) const { return bins_[feature]; }

 private:
  std::vector<std::vector<float>> cuts_;
  std::vector<std::vector<std::uint8_t>> bins_;
};

struct Split {
  double gain = 1e-6;
  std::size_t feature = 0;
  std::size_t cut = 0;
  bool found = false;
};

Split best_split(const Bins& bins, const std::vector<int>& node_of, int node,
                 const std::vector<Gradient>& gradients, double smoothing) {
  Split best;
  std::vector<std::size_t> here;
  for (std::size_t i = 0; i < node_of.size(); ++i) {
    if (node_of[i] == node) here.push_back(i);
  }
  Gradient total;
  for (const std::size_t i : here) total += gradients[i];
  for (std::size_t f = 0; f < bins.features(); ++f) {
    std::array<Gradient, 256> sums{};
    const auto& bin = bins.of(f);
    for (const std::size_t i : here) sums[bin[i]] += gradients[i];
    Gradient below;
    for (std::size_t c = 0; c < bins.cuts(f).size(); ++c) {
      below += sums[c];
      const double gain = below.gain(smoothing) + total.minus(below).gain(smoothing) - total.gain(smoothing);
      if (gain > best.gain) best = {gain, f, c, true};
    }
  }
  return best;
}

DecisionTree grow(const Bins& bins, const std::vector<Gradient>& gradients, const BoostingOptions& options) {
  DecisionTree tree;
  std::vector<int> node_of(gradients.size(), 0);
  int first = 0;
  for (int depth = 0; depth < DecisionTree::kDepth; ++depth) {
    const int past = 2 * first + 1;
    std::vector<Split> splits;
    for (int node = first; node < past; ++node) {
      const Split split = best_split(bins, node_of, node, gradients, options.smoothing);
      const auto n = static_cast<std::size_t>(node);
      tree.feature[n] = static_cast<std::uint8_t>(split.feature);
      tree.threshold[n] = split.found ? bins.cuts(split.feature)[split.cut] : kNever;
      splits.push_back(split);
    }
    for (std::size_t i = 0; i < node_of.size(); ++i) {
      const Split& split = splits[static_cast<std::size_t>(node_of[i] - first)];
      const bool yes = split.found && bins.of(split.feature)[i] <= split.cut;
      node_of[i] = 2 * node_of[i] + (yes ? 1 : 2);
    }
    first = past;
  }
  std::array<Gradient, DecisionTree::kLeaves> sums{};
  for (std::size_t i = 0; i < node_of.size(); ++i)
    sums[static_cast<std::size_t>(node_of[i] - DecisionTree::kNodes)] += gradients[i];
  for (std::size_t leaf = 0; leaf < sums.size(); ++leaf) {
    const double value = -options.rate * sums[leaf].first / (sums[leaf].second + options.smoothing);
    tree.leaf[leaf] = rounded(value);
  }
  return tree;
}

}  // namespace

BoostedTrees boost(const FeatureRows& rows, std::span<const std::uint8_t> positive,
                   const BoostingOptions& options) {
  BoostedTrees result;
  const auto count = static_cast<double>(rows.samples());
  const auto ones = static_cast<double>(std::count(positive.begin(), positive.end(), std::uint8_t{1}));
  if (ones == 0.0 || ones == count) return result;
  const Bins bins(rows, options.thresholds);
  result.bias = rounded(std::log(ones / (count - ones)));
  std::vector<float> sums(rows.samples(), result.bias);
  std::vector<Gradient> gradients(rows.samples());
  for (int t = 0; t < options.trees; ++t) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const double p = 1.0 / (1.0 + std::exp(-static_cast<double>(sums[i])));
      gradients[i] = {p - positive[i], p * (1.0 - p)};
    }
    result.trees.push_back(grow(bins, gradients, options));
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += result.trees.back().evaluate(rows[i]);
  }
  return result;
}

}  // namespace bw::people
