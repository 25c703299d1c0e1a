#include "components/local_planner/teb/band_functions.hpp"

#include <algorithm>

namespace bw::teb {

SegmentFunction::SegmentFunction(const BandProblem& problem, std::size_t k) : problem_(problem), k_(k) {
  rows_ = k == 0 ? kSegmentResiduals : kSegmentResiduals - 2;
  if (k + 1 == problem.segments() && !problem.scene.goal_at_rest && k != 0) rows_ = 5;
  set_num_residuals(static_cast<int>(rows_));
  for (std::size_t pose = k; pose <= k + 2 && pose + 1 < problem.band.size(); ++pose) {
    mutable_parameter_block_sizes()->push_back(pose == 0 ? 1 : 4);
  }
}

bool SegmentFunction::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const std::size_t blocks = parameter_block_sizes().size();
  SegmentStates states = problem_.segment(k_, problem_.band.poses.data());
  BandPose start = problem_.band.poses.front();
  if (k_ == 0) {
    start.dt = parameters[0][0];
    states.a = &start.x;
  } else {
    states.a = parameters[0];
  }
  if (blocks > 1) states.b = parameters[1];
  if (blocks > 2) states.c = parameters[2];

  double r[kSegmentResiduals];
  double J[kSegmentResiduals * kSegmentColumns];
  if (!evaluate_segment(problem_.segment_model, states, r, jacobians == nullptr ? nullptr : J)) return false;
  std::copy_n(r, rows_, residuals);
  if (jacobians == nullptr) return true;
  for (std::size_t block = 0; block < blocks; ++block) {
    if (jacobians[block] == nullptr) continue;
    const auto size = static_cast<std::size_t>(parameter_block_sizes()[block]);
    const double* first = J + 4 * block + (size == 1 ? 3 : 0);
    for (std::size_t row = 0; row < rows_; ++row) {
      std::copy_n(first + row * kSegmentColumns, size, jacobians[block] + row * size);
    }
  }
  return true;
}

ClearanceFunction::ClearanceFunction(const BandProblem& problem, std::size_t k, bool along_segment)
    : problem_(problem), k_(k), along_segment_(along_segment) {
  set_num_residuals(static_cast<int>(terms().size()));
  if (k > 0) mutable_parameter_block_sizes()->push_back(4);
  if (along_segment && k + 2 < problem.band.size()) mutable_parameter_block_sizes()->push_back(4);
}

bool ClearanceFunction::Evaluate(double const* const* parameters, double* residuals,
                                 double** jacobians) const {
  const std::vector<BandPose>& poses = problem_.band.poses;
  std::size_t block = 0;
  const double* p = k_ > 0 ? parameters[block++] : &poses[k_].x;
  const double* q = block < parameter_block_sizes().size() ? parameters[block] : &poses[k_ + 1].x;
  const std::vector<ClearanceTerm>& list = terms();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double s = list[i].fraction;
    const Vector2 point((1.0 - s) * p[0] + s * q[0], (1.0 - s) * p[1] + s * q[1]);
    Vector2 gradient;
    residuals[i] = evaluate_clearance(problem_.clearance_model, list[i], point,
                                      jacobians == nullptr ? nullptr : &gradient);
    if (jacobians == nullptr) continue;
    std::size_t column_block = 0;
    const auto write = [&](double share) {
      double* J = jacobians[column_block++];
      if (J == nullptr) return;
      J += 4 * i;
      J[0] = share * gradient.x();
      J[1] = share * gradient.y();
      J[2] = 0.0;
      J[3] = 0.0;
    };
    if (k_ > 0) write(1.0 - s);
    if (column_block < parameter_block_sizes().size()) write(s);
  }
  return true;
}

const std::vector<ClearanceTerm>& ClearanceFunction::terms() const {
  return along_segment_ ? problem_.terms[k_].along_segment : problem_.terms[k_].at_pose;
}

}  // namespace bw::teb
