#include "components/local_planner/teb/band_problem.hpp"

#include <algorithm>
#include <limits>

namespace bw::teb {

BandProblem::BandProblem(const Band& the_band, const BandScene& the_scene, const BandOptions& options,
                         double obstacle_growth)
    : band(the_band),
      scene(the_scene),
      segment_model(options, the_scene.limits),
      clearance_model(options, obstacle_growth),
      terms(associate(the_band, *the_scene.obstacles, options)) {}

SegmentStates BandProblem::segment(std::size_t k, const BandPose* poses) const {
  const bool last = k + 1 == segments();
  const SegmentEnd at_goal = scene.goal_at_rest ? SegmentEnd::rest : SegmentEnd::free;
  return {&poses[k].x, &poses[k + 1].x, last ? nullptr : &poses[k + 2].x,
          last ? at_goal : SegmentEnd::next_segment, k == 0 ? &scene.start_twist : nullptr};
}

BandCost BandProblem::cost(const BandPose* poses) const {
  BandCost sum;
  double r[kSegmentResiduals];
  for (std::size_t k = 0; k < segments(); ++k) {
    if (!evaluate_segment(segment_model, segment(k, poses), r, nullptr)) {
      sum.motion = std::numeric_limits<double>::infinity();
      return sum;
    }
    for (const double value : r) sum.motion += value * value;
    const auto add = [&](const ClearanceTerm& term) {
      const Vector2 p = (1.0 - term.fraction) * poses[k].position() + term.fraction * poses[k + 1].position();
      const double residual = evaluate_clearance(clearance_model, term, p, nullptr);
      sum.obstacle += residual * residual;
    };
    for (const ClearanceTerm& term : terms[k].at_pose) add(term);
    for (const ClearanceTerm& term : terms[k].along_segment) add(term);
  }
  return sum;
}

double BandProblem::largest_information() const {
  std::vector<std::array<double, 4>> diagonal(band.size(), std::array<double, 4>{});
  double r[kSegmentResiduals];
  double J[kSegmentResiduals * kSegmentColumns];
  for (std::size_t k = 0; k < segments(); ++k) {
    if (!evaluate_segment(segment_model, segment(k, band.poses.data()), r, J)) continue;
    for (std::size_t i = 0; i < kSegmentResiduals * kSegmentColumns; ++i) {
      const std::size_t column = i % kSegmentColumns;
      if (k + column / 4 < band.size()) diagonal[k + column / 4][column % 4] += J[i] * J[i];
    }
  }
  double largest = diagonal[0][3];
  for (std::size_t k = 1; k + 1 < band.size(); ++k) {
    // x and y together: the trace of their block is the same in every frame.
    const auto [x, y, theta, dt] = diagonal[k];
    largest = std::max({largest, x + y, theta, dt});
  }
  return largest;
}

}  // namespace bw::teb
