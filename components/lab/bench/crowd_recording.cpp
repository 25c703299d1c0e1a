#include "components/lab/bench/crowd_recording.hpp"

#include <cmath>

namespace bw {

RunRecording record_crowd(const Scene& scene, const SceneFile& file, LocalPlanner& planner) {
  RunRecording recording;
  recording.robot = Footprint{file.closed_loop->robot_radius, {}};
  recording.top_speed = file.limits.v_max;
  recording.goals = {scene.goal.position()};
  recording.limits = file.limits;
  for (const SceneObstacle& o : scene.obstacles)
    if (!o.moves()) recording.shapes.discs.push_back({o.position, o.radius});
  const auto planned = [&](double time, const PlanningProblem& problem, const PlanningResult&) {
    RecordedMoment moment{.time = time, .X_MB = problem.pose, .speed = std::abs(problem.twist.v)};
    moment.twist = problem.twist;
    for (const Mover& mover : problem.movers)
      moment.people.push_back({mover.id, mover.position, mover.velocity, mover.radius});
    recording.moments.push_back(std::move(moment));
  };
  recording.contacts = drive_crowd(
                           scene, file, planner, [] { return 0.0; }, {}, planned)
                           .contacts;
  return recording;
}

}  // namespace bw
