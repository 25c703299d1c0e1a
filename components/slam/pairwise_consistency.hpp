// Loops that support each other (Mangelson 2018).
#pragma once

#include <span>
#include <vector>

#include "components/slam/loop_search.hpp"

namespace bw::slam {

/// Squared Mahalanobis distance by which two loops and the ways between their ends, along the drive, do not close;
/// three degrees of freedom.
double inconsistency(const Loop& a, const Loop& b, std::span<const Submap> submaps);

/// Indices of the largest set of loops that all agree with loop `with`, itself among them; greedy, the best first.
std::vector<std::size_t> supporters(std::size_t with, std::span<const Loop> loops,
                                    std::span<const Submap> submaps);

}  // namespace bw::slam
