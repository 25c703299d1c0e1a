#include "components/lab/bench/crowd_samples.hpp"

#include <utility>

#include <nlohmann/json.hpp>

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Twist2& twist) { return {twist.v, twist.omega}; }

}  // namespace

CrowdEpisode drive_crowd_sampled(const Scene& scene, const SceneFile& file, LocalPlanner& planner,
                                 const CpuClock& clock, std::vector<CrowdSample>& samples) {
  samples.clear();
  const auto stepped = [&](double, const Pose2&, const Twist2& twist) { samples.back().applied = twist; };
  const auto planned = [&](double time, const PlanningProblem& problem, const PlanningResult& result) {
    CrowdSample& sample = samples.emplace_back();
    sample.time = time;
    sample.pose = problem.pose;
    sample.twist = problem.twist;
    sample.command = result.command;
    for (const Mover& mover : problem.movers)
      sample.walkers.push_back({mover.position, mover.velocity, mover.radius});
  };
  return drive_crowd(scene, file, planner, clock, stepped, planned);
}

Json to_json(const std::vector<CrowdSample>& samples) {
  Json list = Json::array();
  for (const CrowdSample& s : samples) {
    Json walkers = Json::array();
    for (const CrowdSample::Walker& w : s.walkers)
      walkers.push_back({w.position.x(), w.position.y(), w.velocity.x(), w.velocity.y(), w.radius});
    list.push_back({{"t", s.time},
                    {"pose", {s.pose.x, s.pose.y, s.pose.theta}},
                    {"twist", to_json(s.twist)},
                    {"command", to_json(s.command)},
                    {"applied", to_json(s.applied)},
                    {"walkers", std::move(walkers)}});
  }
  return list;
}

}  // namespace bw
