// Footprints from corners and from text, checked; larger and smaller ones; their corners in other frames.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "components/model/footprint.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// No corner is farther from base_link [m], and there are no more of them.
inline constexpr double kFarthestCorner = 5.0;
inline constexpr std::size_t kMaxCorners = 64;

/// An outline, or in one sentence why it is none.
struct FootprintResult {
  Footprint footprint;
  std::string fault;  ///< empty: it may be used
};

/// The polygon through `corners`, either way round, convex, around base_link. Corners that are equal or
/// within a side are left out.
FootprintResult footprint_of(std::vector<Vector2> corners);

/// Nav2's form of a polygon: "[[x, y], [x, y], [x, y]]" [m]. An empty text or list: the disc of `radius`.
FootprintResult footprint_of(std::string_view text, double radius);

/// Reads back as the same polygon; "[]" of a disc.
std::string to_text(const Footprint& footprint);

/// The outline moved out by `distance` [m], its sides parallel: all that is nearer to it than that lies in
/// it. Negative: moved in, by half of what is there at most.
Footprint padded(const Footprint& footprint, double distance);

/// The least that holds both: one of them where it holds the other, else the convex polygon around both, for
/// which a disc counts as a polygon of 32 sides around it (its radius is up to 0.5 % larger at their
/// corners).
Footprint hull(const Footprint& a, const Footprint& b);

/// Corners in the frame F that X_FB places the robot in; of a disc `corners_of_disc` on its rim, the first
/// ahead.
std::vector<Vector2> outline(const Footprint& footprint, const Pose2& X_FB, int corners_of_disc);

}  // namespace bw
