// A local planner: follows the plan on arcs (pure pursuit, Coulter 1992), and evades or stops while the way
// ahead is not free.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <components/local_planner/carrot.hpp>
#include <components/local_planner/command_limits.hpp>
#include <components/local_planner/planner_registry.hpp>
#include <components/model/differential_drive.hpp>

struct PurePursuitOptions {
  double speed = 0.6;
  double lookahead = 1.0;

  void fields(auto& v) {
    v("speed", speed, {.unit = "m/s", .min = 0.05, .max = 2, .doc = "while the way is free"});
    v("lookahead", lookahead, {.unit = "m", .min = 0.2, .max = 10, .doc = "aims at the plan this far ahead"});
  }
};

class PurePursuit final : public bw::CheckedPlanner {
 public:
  PurePursuit(const PurePursuitOptions& options, const bw::DrivingOptions& driving)
      : CheckedPlanner(driving), options_(options) {}

 private:
  bw::PlanningResult drive(const bw::PlanningProblem& problem) override {
    const bw::Twist2 twist =
        bw::reachable_twist(twist_towards_plan(problem), problem.twist, problem.limits, problem.command_lead);
    std::vector<bw::TrajectoryPoint> trajectory{{0.0, problem.pose, problem.twist}};
    for (double time = 0.1; time < driving().feasibility_check_time; time += 0.1)
      trajectory.push_back({time, bw::advance_exact(problem.pose, twist, time), twist});
    bw::PlanningResult result;
    result.status = bw::PlanningStatus::ok;
    result.command = twist;
    const bw::Safety safety = bw::safety_of(trajectory, problem, driving());
    result.trajectory = std::move(trajectory);
    bw::evade(problem, driving(), safety, result);  // changes nothing while the way ahead is free
    return result;
  }

  // The arc from the robot's heading through a point (x, y) of its frame has the curvature 2 y / (x^2 + y^2).
  bw::Twist2 twist_towards_plan(const bw::PlanningProblem& problem) const {
    const bw::Vector2 aim = bw::carrot(problem.plan, problem.pose.position(), options_.lookahead);
    const bw::Vector2 aim_in_robot = bw::inverse(problem.pose) * aim;
    if (aim_in_robot.x() <= 0.0) return {0.0, std::copysign(problem.limits.omega_max, aim_in_robot.y())};
    const double curvature = 2.0 * aim_in_robot.y() / aim_in_robot.squaredNorm();
    const double turning = problem.limits.omega_max / std::max(std::abs(curvature), 1e-6);
    const double braking = std::sqrt(2.0 * problem.limits.acc_max * aim_in_robot.norm());
    const double v = std::min({options_.speed, problem.limits.v_max, turning, braking});
    return {v, v * curvature};
  }

  void forget() override {}  // nothing is kept from call to call

  PurePursuitOptions options_;
};

BW_PLANNER(PurePursuit, PurePursuitOptions, "pure_pursuit")
