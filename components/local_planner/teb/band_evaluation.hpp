// All terms of a band in one pass, headings and speeds once per pose: its cost, and the normal equations of
// both solvers.
#pragma once

#include <vector>

#include "components/local_planner/teb/band_problem.hpp"
#include "components/local_planner/teb/normal_equations.hpp"

namespace bw::teb {

/// Keeps a reference to `problem`, whose clearance model may change in between. Allocates when it is made,
/// never later.
class BandEvaluation {
 public:
  explicit BandEvaluation(const BandProblem& problem);

  /// The cost at these poses (as many as the problem has), which must stay until linearise(). False, and
  /// infinite, when an interval is too short to divide by.
  bool evaluate(const BandPose* poses);
  const BandCost& cost() const { return cost_; }

  /// The equations at the poses last evaluated, with success. Returns the largest diagonal entry of J'J
  /// without the obstacles, x and y of a pose taken together: the scale of the damping, in every frame the
  /// same.
  double linearise(NormalEquations& equations) const;

 private:
  /// Residual of a clearance term, with its gradient.
  struct Clearance {
    double fraction;
    double residual;
    Eigen::Vector3d gradient;
  };

  SegmentStates segment(std::size_t k) const;
  void evaluate_clearances(const BandPose* poses);
  void add_motion(std::size_t k, NormalEquations& equations) const;

  const BandProblem& problem_;
  BandCost cost_;
  std::vector<Heading> headings_;       // of every pose
  std::vector<SegmentMotion> motions_;  // of every segment
  std::vector<Clearance> clearances_;   // of all segments, those that cost something
  std::vector<std::size_t> first_;      // of segment k in clearances_, and where the last one ends
};

}  // namespace bw::teb
