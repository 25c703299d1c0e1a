// A cell in which it matters where in it the robot stands, and which way it faces.
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "components/model/footprint.hpp"
#include "components/model/footprint_distance.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// Headings are looked at in 64 directions: bit i is i * kHeadingStep.
inline constexpr int kHeadings = 64;
inline constexpr double kHeadingStep = 2.0 * std::numbers::pi / kHeadings;
inline constexpr std::uint64_t kAllHeadings = ~std::uint64_t{0};

struct NarrowCell {
  Vector2 position{0.0, 0.0};             ///< of the cell, that farthest from obstacles [m]
  double clearance = 0.0;                 ///< there [m]
  std::uint64_t headings = kAllHeadings;  ///< in which the footprint is free there
};

/// Smallest distance [m] from a point to them; below 0 inside one, infinite without any.
double clearance_of(const Vector2& point, const std::vector<Capsule>& obstacles);

/// Of a square cell of edge `edge` [m] around `center`, by a search whose steps halve: below the best by a
/// tenth of the edge where clearance has several peaks in the cell. `near` are the obstacles that may matter.
/// `headings` is not looked at.
NarrowCell best_position(const Vector2& center, double edge, const std::vector<Capsule>& near);

/// Headings in which the footprint is free at `position`.
std::uint64_t free_headings(const Footprint& footprint, const Vector2& position,
                            const std::vector<Capsule>& near);

/// The headings within an eighth of a turn, half to either side, of a direction [rad] or of its opposite.
std::uint64_t headings_along(double direction);

}  // namespace bw
