#include "components/local_planner/teb/band_evaluation.hpp"

#include <algorithm>
#include <limits>

namespace bw::teb {
namespace {

std::size_t count_terms(const BandProblem& problem) {
  std::size_t count = 0;
  for (const PoseTerms& terms : problem.terms) count += terms.at_pose.size() + terms.along_segment.size();
  return count;
}

}  // namespace

BandEvaluation::BandEvaluation(const BandProblem& problem)
    : problem_(problem), motions_(problem.segments()), first_(problem.poses) {
  headings_.reserve(problem.poses);
  clearances_.reserve(count_terms(problem));
}

SegmentStates BandEvaluation::segment(std::size_t k) const {
  const bool last = k + 1 == problem_.segments();
  const SegmentEnd at_goal = problem_.scene.goal_at_rest ? SegmentEnd::rest : SegmentEnd::free;
  return {headings_[k],
          headings_[k + 1],
          motions_[k],
          last ? nullptr : &motions_[k + 1],
          last ? at_goal : SegmentEnd::next_segment,
          k == 0 ? &problem_.scene.start_twist : nullptr};
}

bool BandEvaluation::evaluate(const BandPose* poses) {
  cost_ = {};
  headings_.clear();
  for (std::size_t k = 0; k < problem_.poses; ++k) headings_.emplace_back(&poses[k].x);
  for (std::size_t k = 0; k < problem_.segments(); ++k) {
    if (evaluate_motion(problem_.segment_model, headings_[k], headings_[k + 1], motions_[k])) continue;
    cost_.motion = std::numeric_limits<double>::infinity();
    return false;
  }
  for (std::size_t k = 0; k < problem_.segments(); ++k) {
    cost_.motion += segment_cost(problem_.segment_model, segment(k));
  }
  evaluate_clearances(poses);
  return true;
}

void BandEvaluation::evaluate_clearances(const BandPose* poses) {
  clearances_.clear();
  for (std::size_t k = 0; k < problem_.segments(); ++k) {
    first_[k] = clearances_.size();
    const auto add = [&](const ClearanceTerm& term) {
      const Pose2 pose = between(&poses[k].x, &poses[k + 1].x, term.fraction);
      Eigen::Vector3d gradient;
      const double residual = evaluate_clearance(problem_.clearance_model, term, pose, &gradient);
      if (residual == 0.0) return;
      cost_.obstacle += residual * residual;
      clearances_.push_back({term.fraction, residual, gradient});
    };
    for (const ClearanceTerm& term : problem_.terms[k].at_pose) add(term);
    for (const ClearanceTerm& term : problem_.terms[k].along_segment) add(term);
  }
  first_[problem_.segments()] = clearances_.size();
}

void BandEvaluation::add_motion(std::size_t k, NormalEquations& equations) const {
  SegmentRows rows;
  evaluate_segment(problem_.segment_model, segment(k), rows);
  for (std::size_t i = 0; i < rows.active; ++i) {
    equations.add(k, rows.jacobian[i].data(), rows.residuals[rows.of_row[i]]);
  }
}

double BandEvaluation::linearise(NormalEquations& equations) const {
  equations.reset(problem_.poses);
  for (std::size_t k = 0; k < problem_.segments(); ++k) add_motion(k, equations);
  const double largest = equations.largest_information();
  for (std::size_t k = 0; k < problem_.segments(); ++k) {
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) {
      const Clearance& c = clearances_[i];
      equations.add(k, c.fraction, c.gradient, c.residual);
    }
  }
  equations.fix_ends();
  return largest;
}

}  // namespace bw::teb
