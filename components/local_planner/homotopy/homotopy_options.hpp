// Parameters of the exploration of distinctive topologies (theory.md 6.2). Names follow the public
// teb_local_planner package where it has them.
#pragma once

#include <cstdint>

#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::homotopy {

/// Vertices of the graph that is searched.
enum class Vertices { keypoints, roadmap };
constexpr auto choice_table(Vertices) {
  return choices<Vertices>({{Vertices::keypoints, "keypoints"}, {Vertices::roadmap, "roadmap"}});
}

enum class SearchOrder { best_first, depth_first };
constexpr auto choice_table(SearchOrder) {
  return choices<SearchOrder>(
      {{SearchOrder::best_first, "best_first"}, {SearchOrder::depth_first, "depth_first"}});
}

/// What tells classes of paths apart.
enum class ClassMeasure { winding, h_signature };
constexpr auto choice_table(ClassMeasure) {
  return choices<ClassMeasure>(
      {{ClassMeasure::winding, "winding"}, {ClassMeasure::h_signature, "h_signature"}});
}

/// Where a mover stands in the way of a path.
enum class MoverTopology {
  time_indexed,  ///< where it is when the robot passes
  capsule,       ///< all of its way of prediction_horizon
  present,
};
constexpr auto choice_table(MoverTopology) {
  return choices<MoverTopology>({{MoverTopology::time_indexed, "time_indexed"},
                                 {MoverTopology::capsule, "capsule"},
                                 {MoverTopology::present, "present"}});
}

/// Difference of H-signatures from which classes differ.
inline constexpr double kHSignatureThreshold = 0.1;
/// Cosine between goal and a place beside an obstacle below which it is no vertex, and between goal and edge
/// above which the edge goes forward.
inline constexpr double kVertexHeading = 0.1;
inline constexpr double kEdgeHeading = 0.45;
/// Random vertices that method roadmap draws, and the width of the strip around the line to the goal that is
/// explored [m].
inline constexpr int kRoadmapVertices = 15;
inline constexpr double kAreaWidth = 6.0;

struct HomotopyOptions {
  int max_number_classes = 4;
  MoverTopology mover_topology = MoverTopology::time_indexed;
  double selection_cost_hysteresis = 0.95;
  double selection_obst_cost_scale = 1.0;
  double switching_blocking_period = 0.0;

  /// [m] how far beyond the wanted clearance a keypoint lies
  static constexpr double kObstacleKeypointOffset = 0.1;

  // Set by code.
  int max_bodies = 20;  ///< obstacles (merged where the robot does not fit between) told apart; of more, the
                        ///< nearest to the line to the goal
  Vertices method = Vertices::keypoints;           ///< where paths may lead through
  SearchOrder search = SearchOrder::best_first;    ///< depth_first: those that are met first, as published
  ClassMeasure signature = ClassMeasure::winding;  ///< h_signature loses its digits beyond about 10 obstacles
  int max_expansions = 2000;             ///< vertices that the search may visit in one cycle; bounds its time
  double prediction_horizon = 1.6;       ///< [s] of a mover's way that belongs to it (capsule)
  std::uint64_t roadmap_graph_seed = 1;  ///< of the random vertices of method roadmap

  template <class Visitor>
  void fields(Visitor& v) {
    v("max_number_classes", max_number_classes,
      {.min = 1,
       .max = 20,
       .doc = "how many bands in different topologies compete; each costs an optimisation"});
    v("mover_topology", mover_topology,
      {.doc = "time_indexed: movers where they are when the robot passes; capsule: with their way of "
              "prediction_horizon; present: where they stand"});
    v("selection_cost_hysteresis", selection_cost_hysteresis,
      {.min = 0,
       .max = 1,
       .doc = "share of the present candidate's cost that another must undercut; lower switches less"});
    v("selection_obst_cost_scale", selection_obst_cost_scale,
      {.min = 0,
       .max = 1e4,
       .doc = "weight of the cost of obstacles in the choice between bands; raise it to prefer wide ways "
              "over short ones; 100 in teb_local_planner"});
    v("switching_blocking_period", switching_blocking_period,
      {.unit = "s",
       .min = 0,
       .max = 60,
       .doc = "time after a change of topology before the next one; raise it when the robot wavers"});
    v.retired({"max_bodies", "method", "search", "signature", "obstacle_keypoint_offset"},
              "set by code alone, in homotopy_options.hpp");
  }
};

}  // namespace bw::homotopy
