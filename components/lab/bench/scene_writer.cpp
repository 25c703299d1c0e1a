#include "components/lab/bench/scene_writer.hpp"

#include <fmt/format.h>

namespace bw {
namespace {

std::string flow(const Pose2& p) { return fmt::format("{{x: {}, y: {}, theta: {}}}", p.x, p.y, p.theta); }

std::string head(const SceneFile& file) {
  const Limits& l = file.limits;
  const SceneWeights& w = file.weights;
  std::string out = "version: 1\n";
  out += fmt::format("replan_period: {}\nwarm_cycles: {}\n", file.replan_period, file.warm_cycles);
  if (file.closed_loop) {
    const ClosedLoop& c = *file.closed_loop;
    out += fmt::format("control_period: {}\ntimeout: {}\ngoal_tolerance: {}\nrobot_radius: {}\n",
                       c.control_period, c.timeout, c.goal_tolerance, c.robot_radius);
    out += fmt::format("box: {{x_min: {}, x_max: {}, y_min: {}, y_max: {}}}\n", c.box.x_min, c.box.x_max,
                       c.box.y_min, c.box.y_max);
  }
  out += fmt::format("limits: {{v_max: {}, v_back_max: {}, omega_max: {}, acc_max: {}, alpha_max: {}}}\n",
                     l.v_max, l.v_back_max, l.omega_max, l.acc_max, l.alpha_max);
  out += fmt::format("band: {{dt_ref: {}, dt_hysteresis: {}}}\n", file.dt_ref, file.dt_hysteresis);
  out += fmt::format("obstacles_cfg: {{min_dist: {}, inflation_dist: {}, dynamic_inflation_dist: {}}}\n",
                     file.min_dist, file.inflation_dist, file.dynamic_inflation_dist);
  out += fmt::format(
      "weights: {{max_vel_x: {}, max_vel_theta: {}, acc_lim_x: {}, acc_lim_theta: {}, kinematics_nh: {}, "
      "forward_drive: {}, time: {}, obstacle: {}, inflation: {}, dynamic_obstacle: {}, "
      "dynamic_inflation: {}, penalty_epsilon: {}}}\n",
      w.max_vel_x, w.max_vel_theta, w.acc_lim_x, w.acc_lim_theta, w.kinematics_nh, w.forward_drive, w.time,
      w.obstacle, w.inflation, w.dynamic_obstacle, w.dynamic_inflation, w.penalty_epsilon);
  return out;
}

}  // namespace

std::string to_yaml(const SceneFile& file) {
  std::string out = head(file) + "scenes:\n";
  for (const Scene& scene : file.scenes) {
    out += fmt::format("  - name: {}\n    start: {}\n    goal: {}\n    obstacles:{}\n", scene.name,
                       flow(scene.start), flow(scene.goal), scene.obstacles.empty() ? " []" : "");
    for (const SceneObstacle& o : scene.obstacles) {
      out += fmt::format("      - {{x: {}, y: {}, r: {}, vx: {}, vy: {}}}\n", o.position.x(), o.position.y(),
                         o.radius, o.velocity.x(), o.velocity.y());
    }
  }
  return out;
}

}  // namespace bw
