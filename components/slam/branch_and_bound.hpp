// The best pose of a window by branch and bound on max-grids (Hess et al. 2016): that of trying every pose,
// at a fraction of them (theory.md 10.7).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "components/slam/correlative_search.hpp"
#include "components/slam/max_grids.hpp"

namespace bw::slam {

/// Nothing where no pose scores more than `least`. `visited`: how many squares and poses were looked at,
/// added to it.
std::optional<Correlation> branch_and_bound(const MaxGrids& grids, std::span<const Vector2> points,
                                            const Pose2& start, const SearchWindow& window, double least,
                                            std::int64_t& visited);

}  // namespace bw::slam
