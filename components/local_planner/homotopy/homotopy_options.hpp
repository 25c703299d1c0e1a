// Parameters of the exploration of distinctive topologies (book 6.2). Names follow the public
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

struct HomotopyOptions {
  int max_number_classes = 4;
  int max_bodies = 20;
  int max_expansions = 2000;
  Vertices method = Vertices::keypoints;
  SearchOrder search = SearchOrder::best_first;
  ClassMeasure signature = ClassMeasure::winding;
  MoverTopology mover_topology = MoverTopology::time_indexed;
  double prediction_horizon = 1.6;
  double h_signature_threshold = 0.1;
  double obstacle_keypoint_offset = 0.1;
  double obstacle_heading_threshold = 0.1;
  double edge_heading_threshold = 0.45;
  int roadmap_graph_no_samples = 15;
  double roadmap_graph_area_width = 6.0;
  std::int64_t roadmap_graph_seed = 1;
  double selection_cost_hysteresis = 0.95;
  double selection_obst_cost_scale = 1.0;
  double switching_blocking_period = 0.0;
  double max_ratio_detours_duration_best_duration = 3.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("max_number_classes", max_number_classes,
      {.min = 1,
       .max = 20,
       .doc = "how many bands in different topologies compete; each costs an optimisation"});
    v("max_bodies", max_bodies,
      {.min = 0,
       .max = 100,
       .doc = "how many obstacles (merged where the robot does not fit between) are told apart; of more, "
              "the nearest to the line to the goal"});
    v("max_expansions", max_expansions,
      {.min = 1, .max = 1e6, .doc = "vertices that the search may visit in one cycle; bounds its time"});
    v("method", method,
      {.doc = "where paths may lead through: keypoints beside each obstacle, or a random roadmap"});
    v("search", search,
      {.doc = "best_first: the shortest classes come first; depth_first: those that are met first, as "
              "published"});
    v("signature", signature,
      {.doc = "how classes are told apart; h_signature loses its digits beyond about 10 obstacles"});
    v("mover_topology", mover_topology,
      {.doc = "time_indexed: movers where they are when the robot passes; capsule: with their way of "
              "prediction_horizon; present: where they stand"});
    v("prediction_horizon", prediction_horizon,
      {.unit = "s",
       .min = 0,
       .max = 20,
       .doc = "how long a way ahead of a mover belongs to it (mover_topology: capsule)"});
    v("h_signature_threshold", h_signature_threshold,
      {.min = 1e-6, .max = 10, .doc = "difference of H-signatures from which classes differ"});
    v("obstacle_keypoint_offset", obstacle_keypoint_offset,
      {.unit = "m",
       .min = 0,
       .max = 2,
       .doc = "how far beyond the wanted clearance a keypoint lies; raise it when bands begin too close"});
    v("obstacle_heading_threshold", obstacle_heading_threshold,
      {.min = 0,
       .max = 1,
       .doc = "cosine between goal and a place beside an obstacle below which it is no vertex"});
    v("edge_heading_threshold", edge_heading_threshold,
      {.min = 0, .max = 1, .doc = "cosine between goal and edge above which the edge goes forward"});
    v("roadmap_graph_no_samples", roadmap_graph_no_samples,
      {.min = 1, .max = 200, .doc = "how many random vertices method roadmap draws"});
    v("roadmap_graph_area_width", roadmap_graph_area_width,
      {.unit = "m",
       .min = 0.1,
       .max = 50,
       .doc = "width of the strip around the line to the goal that is explored; raise it where detours "
              "lead further aside"});
    v("roadmap_graph_seed", roadmap_graph_seed,
      {.min = 0, .doc = "seed of the random vertices of method roadmap"});
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
    v("max_ratio_detours_duration_best_duration", max_ratio_detours_duration_best_duration,
      {.min = 1, .max = 100, .doc = "a band this many times longer than the driven one is given up"});
  }
};

}  // namespace bw::homotopy
