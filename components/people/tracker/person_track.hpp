// What the tracker keeps of somebody.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "components/people/tracker/cluster_track.hpp"
#include "components/people/tracker/heading_filter.hpp"
#include "components/people/tracker/occlusion_memory.hpp"
#include "components/people/tracker/walker.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

/// Where somebody was, and how they moved.
struct PastState {
  double time = 0.0;  ///< [s], from the tracker's own origin
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
};

struct PersonTrack {
  std::uint32_t id = 0;
  Walker walker;
  HeadingFilter heading;  ///< what is reported
  Time born;
  Time confirmed;
  Time last_seen;                         ///< by a laser
  double since_seen = 0.0;                ///< from the time before to that [s]
  std::optional<OcclusionMemory> hidden;  ///< where they may be while not seen for sure
  double there = 1.0;    ///< how probably they are near where they are tracked, if they are somebody
  PastState sure;        ///< when they were last seen as a person or a leg plainly is
  PastState free;        ///< when last seen where nothing had stood for long
  PastState settled;     ///< when their legs last went like those of one person
  bool strayed = false;  ///< since `free` furniture was followed in their place: nobody is believed for them
  double score = 0.5;    ///< smoothed human score of what was seen
  FootShifts foot_shifts;      ///< of the offset from leg to leg
  Existence existence;         ///< how sure it is that they are a person
  double empty_seconds = 0.0;  ///< for so long the laser saw through where they should be [s]
  double heard = 0.0;          ///< how sure other detectors are that they are there, 0 to 1
  Time last_heard;             ///< when one of them told of this person last, if `heard` is not 0
  // Of each leg:
  std::array<double, 2> unseen{};                   ///< since it was seen, or the whole [s]
  std::array<std::optional<ClusterTrack>, 2> legs;  ///< what was seen of it lately

  /// `leg` 0 or 1. What is too far from where the leg was, or too late, is the first sight of another.
  void remember_leg(std::size_t leg, const Sighting& seen);

  /// When last seen for sure.
  bool stood() const { return !strayed && sure.velocity.norm() <= HiddenOptions::kStoodSpeed; }

  Time last_known() const { return std::max(last_seen, last_heard); }

  bool both_legs_seen(std::int64_t sweep) const {
    return legs[0] && legs[1] && legs[0]->last().sweep == sweep && legs[1]->last().sweep == sweep;
  }
};

}  // namespace bw::people
