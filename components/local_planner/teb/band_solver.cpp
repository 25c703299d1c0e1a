#include "components/local_planner/teb/band_solver.hpp"

namespace bw::teb {
namespace {

constexpr std::size_t kLookBack = 4;  // iterations over which the fall of the cost is taken
constexpr double kFastFall = 0.15;    // share of it by which it falls

}  // namespace

bool SolveProgress::ends(double cost, double gain) {
  costs_.push_back(gain > 0.0 ? cost : costs_.back());
  const int iterations = static_cast<int>(costs_.size()) - 1;
  if (gain > 0.0 && limits_.is_lost(cost, gain, iterations)) return true;
  if (iterations < limits_.max_iterations) return false;
  if (iterations >= limits_.max_iterations + limits_.overtime || costs_.size() <= kLookBack) return true;
  return costs_.back() > (1.0 - kFastFall) * costs_[costs_.size() - 1 - kLookBack];
}

}  // namespace bw::teb
