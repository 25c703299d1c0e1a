#include "components/local_planner/dwa/hrvo_guide.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "components/local_planner/dwa/led_plan.hpp"
#include "components/model/mover_weight.hpp"

namespace bw::dwa {
namespace {

constexpr double kStep = 0.25;  // [s]

}  // namespace

bool somebody_within(const PlanningProblem& problem, double horizon) {
  const double speed = std::max(problem.limits.v_max, std::abs(problem.twist.v));
  const int steps = static_cast<int>(std::ceil(horizon / kStep));
  for (const Mover& m : problem.movers) {
    if (!is_confirmed(m) || m.velocity.norm() < kStanding) continue;
    for (int i = 0; i <= steps; ++i) {
      const double time = std::min(i * kStep, horizon);
      const double apart = (m.position_at(time) - problem.pose.position()).norm();
      if (apart <= speed * time + m.radius + problem.footprint.radius) return true;
    }
  }
  return false;
}

HrvoGuide::HrvoGuide(const PlanningProblem& problem, hrvo::Advice advice, const EdwaOptions& options)
    : pose_(problem.pose), advice_(std::move(advice)), options_(options) {}

bool HrvoGuide::has_direction() const { return advice_.velocity.norm() >= hrvo::kNoDirection; }

double HrvoGuide::cost(const RollOut& roll_out) const {
  const double wanted = std::atan2(advice_.velocity.y(), advice_.velocity.x());
  const double heading = pose_.theta + roll_out.twist.omega * kHeadingTime;
  const double slower = options_.hrvo_speed ? std::abs(roll_out.twist.v - advice_.velocity.norm()) : 0.0;
  return options_.heading_scale * std::abs(wrap_angle(wanted - heading)) +
         options_.advised_speed_scale * slower;
}

}  // namespace bw::dwa
