// What the page shows of a bag, as an MCAP file in memory.
#pragma once

#include "runtime/recording/bag/bag.hpp"

namespace bw {

/// More is no page but a bag, to be looked at with `bandwagon view` [bytes].
inline constexpr std::uint64_t kLargestPageBag = std::uint64_t{256} << 20;

/// Topics by type; wheel commands, the laser's legs and whatever else has no place on the page is left out.
/// Damaged messages are too.
/// Throws std::runtime_error where more than kLargestPageBag is left.
bag::Bytes shown_bag(const bag::Bag& bag);

}  // namespace bw
