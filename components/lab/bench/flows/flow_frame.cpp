#include "components/lab/bench/flows/flow_frame.hpp"

#include <fmt/format.h>

namespace bw {
namespace {

Limits flow_limits() {
  return {.v_max = 1.0,
          .v_back_max = 0.2,
          .omega_max = 2.5,
          .acc_max = 1.0,
          .alpha_max = 3.0,
          .jerk_max = 5.0,
          .stop_deceleration = 2.0};
}

}  // namespace

void add_walls_along(StaticObstacles& walls, double half_width, double from, double to) {
  for (const double y : {-half_width, half_width}) walls.segments.push_back({{from, y}, {to, y}});
}

DriveScene along_the_middle(const char* name, std::uint64_t seed, double end, double timeout) {
  DriveScene scene;
  scene.name = fmt::format("{} seed {}", name, seed);
  scene.limits = flow_limits();
  scene.timeout = timeout;
  scene.walls_count = true;
  scene.is_done = [end](const Pose2& pose) { return pose.x > end; };
  scene.path = [](const Pose2& pose) {
    return std::vector<Pose2>{{pose.x, 0.0, 0.0}, {pose.x + kFlowAhead, 0.0, 0.0}};
  };
  return scene;
}

DriveScene in_a_corridor(const char* name, std::uint64_t seed, double half_width, double end,
                         double timeout) {
  DriveScene scene = along_the_middle(name, seed, end, timeout);
  add_walls_along(scene.walls, half_width, kFlowLoop.from, kFlowLoop.to);
  return scene;
}

SocialWalkersOptions flow_walkers() {
  SocialWalkersOptions options;
  options.turn_round = false;
  options.forces.social_factor = 5.1;
  options.forces.obstacle_sigma = 0.2;
  return options;
}

}  // namespace bw
