// Weight of a set per bin of pose space, 0.5 m x 0.5 m x 10 degrees as AMCL has them: how many particles are
// enough, and which of them belong together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "components/localization/particle_filter/particle_set.hpp"

namespace bw::localization {

class PoseHistogram {
 public:
  static constexpr double kCell = 0.5;  ///< [m]
  static constexpr int kHeadings = 36;

  void fill(const ParticleSet& particles);

  std::size_t bins() const { return weight_.size(); }
  /// By bin, in the order of first particles.
  const std::vector<double>& weights() const { return weight_; }
  /// Bin of every particle.
  const std::vector<std::uint32_t>& bin_of() const { return bin_of_; }

  /// Bins expected to hold a particle when `count` are drawn by weight.
  double expected_bins(double count) const;

  /// Numbers the bins by group, neighbours (also across corners) in one; bins lighter than `share` of the
  /// heaviest join none. Returns the number of the heaviest group.
  int group(double share);
  /// By bin; -1: none.
  const std::vector<int>& group_of() const { return group_of_; }
  /// By group.
  const std::vector<double>& group_weights() const { return group_weight_; }

 private:
  struct Key {
    std::int32_t x, y, heading;
    bool operator==(const Key&) const = default;
  };
  std::size_t slot_of(const Key& key) const;

  std::vector<std::uint32_t> slots_;  ///< hash table: bin + 1, 0 where empty
  std::vector<Key> key_;              ///< by bin
  std::vector<double> weight_;        ///< by bin
  std::vector<std::uint32_t> bin_of_;
  std::vector<int> group_of_;
  std::vector<double> group_weight_;
  std::vector<std::uint32_t> open_;
};

/// The least count, within [least, most], at which the particles drawn are as many as kld_bound() asks for
/// the bins that so many are expected to hold: where Fox's rule, drawing one by one, stops.
std::size_t kld_count(const PoseHistogram& histogram, double error, double z, std::size_t least,
                      std::size_t most);

}  // namespace bw::localization
