#include "components/local_planner/orca/orca_planner.hpp"

#include <algorithm>
#include <numbers>

#include "components/local_planner/carrot.hpp"
#include "components/local_planner/hrvo/neighbours.hpp"
#include "components/local_planner/orca/orca.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/local_planner/velocity_tracking.hpp"

namespace bw::orca {
namespace {

constexpr int kMaxNeighbours = 10;  // as CrowdNav has it

// HRVO and ORCA look at the same neighbours, and differ in what they make of them.
hrvo::HrvoOptions who_is_looked_at(const OrcaOptions& options) {
  return {.margin = options.margin,
          .neighbour_range = options.kNeighbourRange,
          .reciprocity = options.reciprocity,
          .view_angle = 2.0 * std::numbers::pi,
          .max_neighbours = kMaxNeighbours};
}

Advice advise_robot(const PlanningProblem& problem, const Vector2& aim, const OrcaOptions& options) {
  const hrvo::HrvoOptions looking = who_is_looked_at(options);
  // Radii of neighbours are those of both together here: the robot is a point.
  const Agent robot{.position = problem.pose.position(),
                    .velocity = problem.twist.v * direction(problem.pose.theta),
                    .radius = 0.0,
                    .wanted = velocity_towards(aim, problem, hrvo::kTimeStep),
                    .v_max = problem.limits.v_max};
  std::vector<Neighbour> movers;
  for (const hrvo::Neighbour& n : hrvo::moving_neighbours(problem, looking))
    movers.push_back({n.core.a, n.velocity, n.radius, n.shares ? 0.5 : 1.0});
  std::vector<Wall> walls;
  for (const hrvo::Neighbour& n : hrvo::static_neighbours(problem, aim, looking))
    walls.push_back({n.core, n.radius});
  return advise(robot, movers, walls,
                {.neighbour_range = options.kNeighbourRange,
                 .max_neighbours = kMaxNeighbours,
                 .horizon = options.horizon,
                 .wall_horizon = options.kStaticHorizon,
                 .time_step = hrvo::kTimeStep});
}

}  // namespace

PlanningResult OrcaPlanner::drive(const PlanningProblem& problem) {
  // The point aimed at is no goal to brake for unless it is the last one.
  const double braking = problem.limits.v_max * problem.limits.v_max / (2.0 * problem.limits.acc_max);
  const Vector2 aim = carrot(problem.plan, problem.pose.position(), std::max(options_.lookahead, braking));
  const Advice advice = advise_robot(problem, aim, options_);
  PlanningResult result;
  result.iterations = 1;
  for (const HalfPlane& h : advice.half_planes)
    result.velocity_cones.push_back({h.point, -h.direction, h.direction});
  result.velocity_wanted = advice.velocity;
  track_velocity(problem, driving(), advice.velocity, aim, result);
  return result;
}

BW_PLANNER(OrcaPlanner, OrcaOptions, "orca")

}  // namespace bw::orca
