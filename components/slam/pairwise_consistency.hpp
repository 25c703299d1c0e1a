// Loops that support each other (Mangelson 2018; theory.md 10.9).
#pragma once

#include <span>
#include <vector>

#include "components/slam/loop_search.hpp"

namespace bw::slam {

/// Squared Mahalanobis distance by which two loops and the ways between their ends, along the drive, do not
/// close; three degrees of freedom.
double inconsistency(const Loop& a, const Loop& b, std::span<const Submap> submaps);

/// Indices of loops that agree with loop `with` and with each other, itself first. Greedy, those that agree
/// best first: a larger set may exist.
std::vector<std::size_t> supporters(std::size_t with, std::span<const Loop> loops,
                                    std::span<const Submap> submaps);

/// Of each of these whether it is believed: it was searched within 0.5 m, or two others agree with it.
std::vector<bool> believed(std::span<const Loop> loops, std::span<const Submap> submaps);

}  // namespace bw::slam
