// Candidate paths in different topologies (theory.md 6.2): what the elastic bands start from.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "components/local_planner/homotopy/h_signature.hpp"
#include "components/local_planner/homotopy/winding.hpp"
#include "components/model/planning.hpp"

namespace bw::homotopy {

/// What a class is told by.
struct Signature {
  std::vector<double> winding;                 ///< by body; always there: it also names the class
  std::complex<double> h_signature{0.0, 0.0};  ///< with signature h_signature only
};
Signature signature_of(const Route& route, const std::vector<Body>& bodies, const Course& course,
                       const HomotopyOptions& options);
bool same_class(const Signature& l, const Signature& r, const HomotopyOptions& options);

struct Path {
  Route route;          ///< from the robot to the local goal, times at v_max
  double length = 0.0;  ///< [m]
  Signature signature;
  std::string label;     ///< sides of the bodies about which the classes disagree, e.g. "LRL"
  bool is_plan = false;  ///< the given plan, not looked at for clearance
};

struct Exploration {
  Course course;
  std::vector<Body> bodies;
  std::vector<Path> paths;        ///< the plan first, then by length
  std::vector<Signature> in_use;  ///< of the routes passed in
  std::vector<std::string> in_use_labels;
  int expansions = 0;  ///< vertices that the search visited
};

/// From problem.pose to the end of problem.plan (not empty) among its obstacles; `clearance` [m] is the
/// wanted gap (the band's min_obstacle_dist). `in_use`: routes already driven or kept, from about the robot
/// to about the goal; their classes are not found again and count among max_number_classes. One path per
/// class, the shortest found; the first is the plan if its class is not in use.
///
/// Bounded by max_number_classes, max_bodies and max_expansions. Depends neither on the order of the
/// obstacles nor on the frame; mirrored scenes give mirrored paths, except that among paths of exactly equal
/// length the one further left is found first (it matters where max_number_classes cuts), and for method
/// roadmap.
Exploration explore(const PlanningProblem& problem, double clearance, const std::vector<Route>& in_use,
                    const HomotopyOptions& options);

}  // namespace bw::homotopy
