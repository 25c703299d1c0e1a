#include "components/lab/comparison/paired.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "components/model/random.hpp"

namespace bw {
namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

double mcnemar_p(int b, int c) {
  const int n = b + c;
  // log of n over k and of 2^n, so that nothing overflows.
  double log_choose = 0.0;
  double sum = 0.0;
  for (int k = 0; k <= std::min(b, c); ++k) {
    if (k > 0) log_choose += std::log(n - k + 1.0) - std::log(static_cast<double>(k));
    sum += std::exp(log_choose - n * std::log(2.0));
  }
  return std::min(1.0, 2.0 * sum);
}

MeanInterval bootstrap_mean(const std::vector<double>& values) {
  std::vector<double> sound;
  std::copy_if(values.begin(), values.end(), std::back_inserter(sound),
               [](double value) { return std::isfinite(value); });
  MeanInterval interval;
  interval.count = static_cast<int>(sound.size());
  if (sound.empty()) return interval;
  interval.mean = mean_of(sound);
  Random random(kBootstrapSeed);
  const std::size_t n = sound.size();
  std::vector<double> means(kBootstrapSamples);
  for (double& mean : means) {
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      sum += sound[static_cast<std::size_t>(random.uniform() * static_cast<double>(n))];
    mean = sum / static_cast<double>(n);
  }
  std::sort(means.begin(), means.end());
  interval.low = means[kBootstrapSamples / 40];
  interval.high = means[kBootstrapSamples - 1 - kBootstrapSamples / 40];
  return interval;
}

Comparison compare(const std::vector<PairedEpisode>& first, const std::vector<PairedEpisode>& second) {
  std::map<std::string, const PairedEpisode*> by_key;
  for (const PairedEpisode& episode : first) by_key[episode.key] = &episode;
  Comparison result;
  std::vector<double> success, index, closest, jerk, time;
  for (const PairedEpisode& b : second) {
    const auto found = by_key.find(b.key);
    if (found == by_key.end()) continue;
    const PairedEpisode& a = *found->second;
    ++result.pairs;
    success.push_back((b.success ? 1.0 : 0.0) - (a.success ? 1.0 : 0.0));
    if (a.success && !b.success) ++result.only_first;
    if (b.success && !a.success) ++result.only_second;
    if (!a.success || !b.success) continue;
    ++result.both;
    index.push_back(b.collision_index - a.collision_index);
    closest.push_back(b.closest - a.closest);
    jerk.push_back(b.jerk - a.jerk);
    time.push_back(b.time - a.time);
  }
  result.p = mcnemar_p(result.only_second, result.only_first);
  result.success = bootstrap_mean(success);
  result.collision_index = bootstrap_mean(index);
  result.closest = bootstrap_mean(closest);
  result.jerk = bootstrap_mean(jerk);
  result.time = bootstrap_mean(time);
  return result;
}

}  // namespace bw
