// Paths through a roadmap, one per class and the shortest first (or depth first, as published).
#pragma once

#include <functional>
#include <vector>

#include "components/local_planner/homotopy/roadmap.hpp"

namespace bw::homotopy {

/// Gets a path from start to goal and its length [m]; false ends the search.
using VisitPath = std::function<bool(const std::vector<Vector2>& points, double length)>;

/// Best first over pairs of vertex and class so far, with the exact length to go as heuristic (Bhattacharya
/// et al. 2010): the first path of each class is its shortest one, and classes come by length. Equal lengths
/// come in the order of the vertices. Returns the pairs expanded, at most max_expansions.
int search_best_first(const Roadmap& map, const std::vector<Body>& bodies, const Course& course,
                      int max_expansions, const VisitPath& visit);

/// All simple paths, depth first (theory.md 6.2), successors by the shortest path on; vertices without a path
/// to the goal are left out. Returns the vertices visited, at most max_expansions.
int search_depth_first(const Roadmap& map, int max_expansions, const VisitPath& visit);

}  // namespace bw::homotopy
