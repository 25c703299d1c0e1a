#include "components/localization/particle_filter/pose_histogram.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "components/localization/particle_filter/weights.hpp"

namespace bw::localization {
namespace {

std::int32_t cell_of(double position) {
  // Further out than 1000 km all is one.
  return static_cast<std::int32_t>(std::floor(std::clamp(position, -1e6, 1e6) / PoseHistogram::kCell));
}

std::int32_t heading_of(double theta) {
  const double part = (theta + std::numbers::pi) * (PoseHistogram::kHeadings * 0.5 * std::numbers::inv_pi);
  return std::clamp(static_cast<std::int32_t>(part), 0, PoseHistogram::kHeadings - 1);
}

}  // namespace

std::size_t PoseHistogram::slot_of(const Key& key) const {
  std::uint64_t h = static_cast<std::uint32_t>(key.x) * 0x9e3779b97f4a7c15ULL;
  h = (h ^ static_cast<std::uint32_t>(key.y)) * 0xc2b2ae3d27d4eb4fULL;
  h = (h ^ static_cast<std::uint32_t>(key.heading)) * 0x9e3779b97f4a7c15ULL;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = static_cast<std::size_t>(h >> 32) & mask;
  while (slots_[slot] != 0 && !(key_[slots_[slot] - 1] == key)) slot = (slot + 1) & mask;
  return slot;
}

void PoseHistogram::fill(const ParticleSet& p) {
  slots_.assign(std::bit_ceil(2 * p.size() + 2), 0);
  key_.clear();
  weight_.clear();
  bin_of_.resize(p.size());
  Key last{};
  std::uint32_t bin = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Key key{cell_of(p.x[i]), cell_of(p.y[i]), heading_of(p.theta[i])};
    if (i == 0 || !(key == last)) {
      last = key;
      std::uint32_t& entry = slots_[slot_of(key)];
      if (entry == 0) {
        key_.push_back(key);
        weight_.push_back(0.0);
        entry = static_cast<std::uint32_t>(key_.size());
      }
      bin = entry - 1;
    }
    weight_[bin] += p.weight[i];
    bin_of_[i] = bin;
  }
}

double PoseHistogram::expected_bins(double count) const {
  double sum = 0.0;
  for (const double w : weight_) sum -= std::expm1(count * std::log1p(-std::min(w, 1.0 - 1e-12)));
  return sum;
}

int PoseHistogram::group(double share) {
  group_of_.assign(key_.size(), -1);
  group_weight_.clear();
  if (key_.empty()) return -1;
  const double least = share * *std::max_element(weight_.begin(), weight_.end());
  for (std::size_t seed = 0; seed < key_.size(); ++seed) {
    if (group_of_[seed] >= 0 || weight_[seed] < least) continue;
    const int group = static_cast<int>(group_weight_.size());
    group_weight_.push_back(0.0);
    group_of_[seed] = group;
    open_.assign(1, static_cast<std::uint32_t>(seed));
    while (!open_.empty()) {
      const std::uint32_t bin = open_.back();
      open_.pop_back();
      group_weight_.back() += weight_[bin];
      for (int step = 0; step < 27; ++step) {
        const Key at = key_[bin];
        const Key key{at.x + step % 3 - 1, at.y + step / 3 % 3 - 1,
                      (at.heading + step / 9 - 1 + kHeadings) % kHeadings};
        const std::uint32_t entry = slots_[slot_of(key)];
        if (entry == 0 || group_of_[entry - 1] >= 0 || weight_[entry - 1] < least) continue;
        group_of_[entry - 1] = group;
        open_.push_back(entry - 1);
      }
    }
  }
  return static_cast<int>(std::max_element(group_weight_.begin(), group_weight_.end()) -
                          group_weight_.begin());
}

std::size_t kld_count(const PoseHistogram& histogram, double error, double z, std::size_t least,
                      std::size_t most) {
  const auto enough = [&](std::size_t count) {
    const double n = static_cast<double>(count);
    return n >= kld_bound(histogram.expected_bins(n), error, z);
  };
  if (enough(least)) return least;
  if (!enough(most)) return most;
  while (most - least > 1) {
    const std::size_t middle = (least + most) / 2;
    (enough(middle) ? most : least) = middle;
  }
  return most;
}

}  // namespace bw::localization
