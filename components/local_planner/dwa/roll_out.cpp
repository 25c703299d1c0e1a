#include "components/local_planner/dwa/roll_out.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/differential_drive.hpp"
#include "components/model/mover_weight.hpp"

namespace bw::dwa {
namespace {

constexpr double kMaxMotion = 0.05;   // [m] that any point of the footprint moves between two looks
constexpr double kMaxSteps = 200;     // a base that is faster than any gets longer ones
constexpr double kMoverStep = 0.1;    // [s] between positions of movers
constexpr double kMaxRotation = 3.0;  // [rad]; a heading reached by rotating on would look like one not left
constexpr double kDeepest = 0.3;      // [m] that it may be inside of something and leave
constexpr double kNoCloserInside = 0.001;  // [m] by which a motion inside the margin may come closer

// Movers that stand where they are become discs.
PlanningProblem frozen(PlanningProblem problem) {
  for (const Mover& m : problem.movers) {
    if (is_confirmed(m)) problem.obstacles.discs.push_back({m.position, m.radius});
  }
  problem.movers.clear();
  return problem;
}

double approach(double now, double target, double change) {
  return std::clamp(target, now - change, now + change);
}

}  // namespace

RollOuts::RollOuts(const PlanningProblem& problem, const RollOutRules& rules)
    : frozen_(rules.predict_movers ? std::nullopt : std::optional(frozen(problem))),
      problem_(frozen_ ? *frozen_ : problem),
      rules_(rules),
      gaps_(problem_, rules.horizon, kMoverStep, rules.reach) {
  gap_now_ = gap_at(problem.pose, 0.0);
  margin_ = std::clamp(gap_now_ - kNoCloserInside, -kDeepest, rules.margin);
}

double RollOuts::gap_at(const Pose2& pose, double time) {
  return gaps_.at(pose, static_cast<std::size_t>(std::lround(time / kMoverStep)), gaps_.farthest()).all;
}

Twist2 RollOuts::velocity_at(const Twist2& held, double time) const {
  const Limits& limits = problem_.limits;
  return {approach(problem_.twist.v, held.v, limits.acc_max * time),
          approach(problem_.twist.omega, held.omega, limits.alpha_max * time)};
}

RollOut RollOuts::along(const Twist2& held) {
  const Twist2& now = problem_.twist;
  const double fastest = std::max(std::abs(held.v), std::abs(now.v)) +
                         std::max(std::abs(held.omega), std::abs(now.omega)) * problem_.footprint.radius;
  const double steps = std::clamp(std::ceil(rules_.horizon * fastest / kMaxMotion), 2.0, kMaxSteps);
  const double dt = rules_.horizon / steps;
  RollOut out{.twist = held, .end = problem_.pose, .gap = gap_now_};
  // No gap changes faster than the footprint moves, and movers.
  double surely = rules_.predict_movers ? 0.0 : gap_now_;
  for (int i = 0; i < static_cast<int>(steps) && out.travel < rules_.distance && out.rotation < kMaxRotation;
       ++i) {
    const Twist2 twist = velocity_at(held, (i + 0.5) * dt);
    const double distance_left = rules_.distance - out.travel;
    const double step = std::abs(twist.v) * dt > distance_left ? distance_left / std::abs(twist.v) : dt;
    const Pose2 next = advance_exact(out.end, twist, step);
    surely -= (std::abs(twist.v) + std::abs(twist.omega) * problem_.footprint.radius) * step;
    if (surely < out.gap) {
      const double gap = gap_at(next, (i + 1) * dt);
      surely = rules_.predict_movers ? 0.0 : gap;
      if (gap < margin_) {
        out.meets = true;
        break;
      }
      if (gap < out.gap) {
        out.gap = gap;
        out.gap_time = (i + 1) * dt;
      }
    }
    out.end = next;
    out.time = i * dt + step;
    out.travel += std::abs(twist.v) * step;
    out.rotation += std::abs(twist.omega) * step;
  }
  return out;
}

std::vector<TrajectoryPoint> RollOuts::trajectory(const Twist2& held, double time) const {
  std::vector<TrajectoryPoint> points{{0.0, problem_.pose, problem_.twist}};
  const int steps = std::max(1, static_cast<int>(std::ceil(time / kMoverStep - 1e-9)));
  const double dt = std::max(time, 0.01) / steps;
  for (int i = 0; i < steps; ++i) {
    const Pose2 next = advance_exact(points.back().pose, velocity_at(held, (i + 0.5) * dt), dt);
    points.push_back({(i + 1) * dt, next, velocity_at(held, (i + 1) * dt)});
  }
  return points;
}

}  // namespace bw::dwa
