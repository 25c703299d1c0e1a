// The messages of a bag, some of them in another order: where a bag does not say in which order its inputs
// were taken, this is how another order is tried.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "runtime/recording/bag/bag.hpp"

namespace bw::replay {

/// Of two messages, by their numbers in the bag from 0, the first comes directly behind the second and at its
/// log time. It is the earlier one in the bag.
struct Delay {
  std::uint64_t message = 0;
  std::uint64_t behind = 0;
  friend bool operator==(const Delay&, const Delay&) = default;
};

/// `messages` from their beginning.
[[nodiscard]] std::unique_ptr<bag::BagMessages> reordered(std::unique_ptr<bag::BagMessages> messages,
                                                          std::vector<Delay> delays);

}  // namespace bw::replay
