// The fields of a graph file in their order and with their rules, once for both ways (graph_file.md).
#pragma once

#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "components/slam/graph_file.hpp"

namespace bw::slam::graph {

// Rules. What lies farther apart is no map, and would be asked for as a grid.
inline constexpr double kFarthest = 1e5;          // [m] submaps from each other
inline constexpr double kFarthestOdometry = 1e7;  // [m]
inline constexpr double kReachOfSubmap = 500.0;   // [m] walls and scans from the frame of their submap
inline constexpr std::int64_t kMaxInteger = std::int64_t{1} << 62;
inline constexpr double kPi = std::numbers::pi;

// Bytes that one of a list takes at least.
inline constexpr std::size_t kSurfaceBytes = 20;
inline constexpr std::size_t kSubmapBytes = 24 + 4 + 24 + 72 + 8 + 1 + 4;
inline constexpr std::size_t kEdgeBytes = 1 + 8 + 24 + 72;
inline constexpr std::size_t kNodeBytes = 4 + 8 + 4 + 24 + 8 + 24 + 8 + 8 + 4;
inline constexpr std::size_t kLoopBytes = kEdgeBytes + 32;

/// How many there are, said in HEAD; of nodes, how many there ever were.
struct Counts {
  std::size_t submaps = 0;
  std::size_t nodes = 0;
  std::size_t under_way = 0;
};

template <class Io, class T>
using Field = std::conditional_t<Io::kReads, T&, const T&>;

template <class Io>
void fields(Io& io, Field<Io, Pose2> X, double farthest) {
  io.real("x", X.x, -farthest, farthest);
  io.real("y", X.y, -farthest, farthest);
  io.real("theta", X.theta, -kPi, kPi);
}

template <class Io>
void fields(Io& io, Field<Io, UncertainPose> X, double farthest) {
  fields(io, X.X, farthest);
  io.covariance(X.covariance);
}

template <class Io>
struct OptionFields {
  Io& io;
  void operator()(const char* name, double& value, const bw::Field& rule) {
    io.real(name, value, rule.min, rule.max);
  }
  void operator()(const char* name, bool& value, const bw::Field&) { io.flag(name, value); }
};

template <class Io>
void fields(Io& io, Field<Io, SlamOptions> options) {
  SlamOptions same = options;
  OptionFields<Io> visitor{io};
  same.fields(visitor);
  same.fixed_fields(visitor);
  if constexpr (Io::kReads) options = same;
}

template <class Io>
void fields(Io& io, Field<Io, std::vector<Surface>> surfaces) {
  io.list("surfaces", surfaces, kSurfaceBytes, [&](auto& surface) {
    io.real("x of a surface", surface.x, -kReachOfSubmap, kReachOfSubmap);
    io.real("y of a surface", surface.y, -kReachOfSubmap, kReachOfSubmap);
    // A mean of unit vectors, rounded.
    io.real("normal_cos2", surface.normal_cos2, -1.001, 1.001);
    io.real("normal_sin2", surface.normal_sin2, -1.001, 1.001);
    io.integer("hits", surface.hits, 1, std::numeric_limits<std::int32_t>::max());
  });
}

template <class Io>
void fields(Io& io, Field<Io, FinishedWalls> walls) {
  if constexpr (Io::kReads) {
    std::vector<Surface> surfaces;
    fields(io, surfaces);
    walls = std::move(surfaces);
  } else {
    const std::vector<Surface>& surfaces = walls;
    fields(io, surfaces);
  }
}

template <class Io>
void fields(Io& io, Field<Io, Submap> submap, Field<Io, Pose2> X_MS, std::size_t index,
            const Counts& counts) {
  fields(io, X_MS, kFarthest);
  io.optional_index("found_in", submap.found_in, index);
  fields(io, submap.X_PS, kFarthest);
  io.index("first_node", submap.first_node, counts.nodes + 1);
  io.index("last_node", submap.last_node, counts.nodes + 1);
  io.optional(submap.marginalised, [&](auto& anchor) {
    io.index("anchor", anchor.submap, counts.submaps);
    fields(io, anchor.X_AS, kFarthest);
  });
  fields(io, submap.surfaces);
}

template <class Io>
void fields(Io& io, Field<Io, SurfaceMap::State> map, double resolution) {
  fields(io, map.surfaces);
  const auto farthest = static_cast<std::int64_t>(kReachOfSubmap / resolution) + 100;
  io.list_of("cells of the surfaces", map.own, map.surfaces.size(), 8, [&](auto& own) {
    io.integer("i", own.i, -farthest, farthest);
    io.integer("j", own.j, -farthest, farthest);
  });
  io.list("cells near surfaces", map.near, 16, [&](auto& near) {
    io.integer("i", near.i, -farthest, farthest);
    io.integer("j", near.j, -farthest, farthest);
    io.integer("surface", near.surface, 0, static_cast<std::int64_t>(map.surfaces.size()) - 1);
    io.real("squared distance", near.squared, 0.0, 1.0);
  });
}

template <class Io>
void fields(Io& io, Field<Io, ScanTracking::State::Active> active, double resolution, const Counts& counts) {
  io.optional_index("found_in", active.joint.found_in, counts.submaps);
  fields(io, active.joint.X_PS, kFarthest);
  fields(io, active.X_SB, kReachOfSubmap);
  fields(io, active.X_before, kReachOfSubmap);
  io.real("travel", active.travel, 0.0, kFarthestOdometry);
  io.index("first_node", active.first_node, counts.nodes + 1);
  fields(io, active.surface, resolution);
}

template <class Io>
void fields(Io& io, Field<Io, ScanTracking::State> tracking, double resolution, const Counts& counts) {
  io.exactly("submap", tracking.submap, counts.submaps, "the number of submaps");
  fields(io, tracking.X_OB, kFarthestOdometry);
  double travel_factor = tracking.trust.travel();
  double turn_factor = tracking.trust.turn();
  io.real("travel_factor", travel_factor, 0.0, 10.0);
  io.real("turn_factor", turn_factor, 0.0, 10.0);
  if constexpr (Io::kReads) tracking.trust = {travel_factor, turn_factor};
  io.integer("time", tracking.time.nanoseconds, -kMaxInteger, kMaxInteger);
  fields(io, tracking.step_before, kFarthestOdometry);
  fields(io, tracking.odometry_before, kFarthestOdometry);
  io.flag("late", tracking.late);
  io.real("since_node", tracking.since_node, 0.0, kFarthestOdometry);
  io.real("turned_since_node", tracking.turned_since_node, 0.0, kFarthestOdometry);
  for (auto* active : {&tracking.older, &tracking.younger})
    io.optional(*active, [&](auto& value) { fields(io, value, resolution, counts); });
}

template <class Io>
void fields(Io& io, Field<Io, Node> node, const Counts& counts) {
  io.integer("time", node.time.nanoseconds, -kMaxInteger, kMaxInteger);
  io.index("submap", node.placement.submap, counts.submaps + counts.under_way);
  fields(io, node.placement.X_SB, kReachOfSubmap);
  io.real("share", node.placement.share, 0.0, 1.0);
  io.shared(node.ranges, [&](auto& ranges) {
    fields(io, ranges.X_BL, 1e6);
    io.real("angle_min", ranges.angle_min, -4.0 * kPi, 4.0 * kPi);
    io.real_either_sign("angle_increment", ranges.angle_increment, 1e-4, 0.5);
    io.list("ranges", ranges.millimetres, 2, [&](auto& mm) { io.short_number(mm); });
  });
}

template <class Io>
void fields(Io& io, Field<Io, Edge> edge, const Counts& counts) {
  io.flag("loop", edge.loop);
  io.index("to", edge.to, counts.submaps);
  io.index("from", edge.from, edge.to);
  fields(io, edge.X, kFarthest);
}

/// A loop, its edge included.
template <class Io>
void fields(Io& io, Field<Io, Loop> loop, const Counts& counts) {
  fields(io, loop.edge, counts);
  io.real("score", loop.score, 0.0, 1.0);
  io.real("inliers", loop.inliers, 0.0, 1.0);
  io.real("through", loop.through, 0.0, 1.0);
  io.real("window", loop.window, 0.0, kFarthestOdometry);
}

template <class Io>
void fields(Io& io, Field<Io, LoopCounts> counts) {
  io.integer("searched", counts.searched, 0, kMaxInteger);
  io.integer("found", counts.found, 0, kMaxInteger);
  io.integer("accepted", counts.accepted, 0, kMaxInteger);
  io.integer("visited", counts.visited, 0, kMaxInteger);
  io.integer("optimisations", counts.optimisations, 0, kMaxInteger);
  io.integer("marginalised", counts.marginalised, 0, kMaxInteger);
}

}  // namespace bw::slam::graph
