// The terms of a band as Ceres sees them: residuals and Jacobians over the free variables alone.
#pragma once

#include <cstddef>
#include <vector>

#include <ceres/cost_function.h>

#include "components/local_planner/teb/band_problem.hpp"

namespace bw::teb {

/// evaluate_segment of segment k. Blocks: the poses k ... k+2 that are free, as (x, y, theta, dt); the start
/// keeps only its dt, the goal none. Keeps a reference to `problem`.
class SegmentFunction final : public ceres::CostFunction {
 public:
  SegmentFunction(const BandProblem& problem, std::size_t k);

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const BandProblem& problem_;
  std::size_t k_;
  std::size_t rows_;
};

/// The clearance terms of pose k (one block), or of segment k (the blocks of those of its ends that are
/// free). There is at least one block and one term. Keeps a reference to `problem`.
class ClearanceFunction final : public ceres::CostFunction {
 public:
  ClearanceFunction(const BandProblem& problem, std::size_t k, bool along_segment);

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const std::vector<ClearanceTerm>& terms() const;

  const BandProblem& problem_;
  std::size_t k_;
  bool along_segment_;
};

}  // namespace bw::teb
