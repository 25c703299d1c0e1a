// What a path can pass on the left or on the right: obstacles that the robot cannot get between are one body.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/local_planner/homotopy/clusters.hpp"
#include "components/local_planner/homotopy/course.hpp"

namespace bw::homotopy {

struct Body {
  std::vector<Part> parts;           ///< its shape; of a mover with `motion`: where the robot may meet it
  Vector2 representative{0.0, 0.0};  ///< a point of it that paths wind around
  std::optional<Mover> motion;       ///< present when it is looked at where it is at the time asked for
  std::optional<std::uint32_t> mover_id;  ///< present for movers

  /// The representative `time` [s] from now.
  Vector2 position_at(double time) const { return motion ? motion->position_at(time) : representative; }
};

/// The bodies between start and goal, at most roadmap_graph_area_width / 2 beside the line, in the order in
/// which they are met. Of more than max_bodies the nearest to the line stay, movers before static ones. The
/// order of the input does not matter. Empty when start and goal coincide.
///
/// Of movers the confirmed (local_planner/theory.md 7.10), by `mover_topology` (D10). time_indexed: the disc
/// where a robot that heads for it at v_max meets it; dropped when that is not before the goal. capsule: all
/// it covers from now until prediction_horizon, so that no path squeezes between a person and that person's
/// future. present: the disc now.
std::vector<Body> bodies_of(const StaticObstacles& obstacles, const std::vector<Mover>& movers,
                            const Course& course, const HomotopyOptions& options);

}  // namespace bw::homotopy
