#include "components/lab/bench/crowdnav_verdict.hpp"

#include <algorithm>
#include <map>

namespace bw {
namespace {

// Somebody's way, and the velocity of each step, which its end has.
struct Walked {
  possible::Walk walk;
  std::vector<Vector2> velocities;
};

std::map<std::uint32_t, Walked> by_person(const CrowdNavWalks& walks) {
  std::map<std::uint32_t, Walked> people;
  for (std::size_t step = 0; step < walks.size(); ++step) {
    for (const CrowdNavAgent& agent : walks[step]) {
      Walked& walked = people[agent.id];
      walked.walk.radius = agent.radius;
      walked.walk.positions.push_back({static_cast<double>(step) * kCrowdNavStep, agent.position});
      walked.velocities.push_back(agent.velocity);
    }
  }
  return people;
}

Vector2 velocity_at(const Walked& walked, double time) {
  const double first = walked.walk.positions.front().time;
  const auto step = static_cast<std::size_t>(std::max(0.0, (time - first) / kCrowdNavStep - 1e-9)) + 1;
  return walked.velocities[std::min(step, walked.velocities.size() - 1)];
}

}  // namespace

std::vector<JudgedContact> judge_crowdnav(const std::vector<possible::MotionState>& motion,
                                          const CrowdNavWalks& walks, const Limits& limits) {
  if (motion.empty() || walks.empty()) return {};
  const std::map<std::uint32_t, Walked> people = by_person(walks);
  possible::SearchScene searched;
  searched.outer_radius = searched.inner_radius = kCrowdNavRadius;
  for (const auto& [id, walked] : people) searched.walks.push_back(walked.walk);
  const double known_until = static_cast<double>(walks.size() - 1) * kCrowdNavStep;
  ContactDiary diary;
  Footprint robot;
  robot.radius = kCrowdNavRadius;
  for (const possible::MotionState& state : motion) {
    TruthSample sample;
    sample.X_MB = state.pose;
    sample.twist = state.twist;
    for (const auto& [id, walked] : people) {
      const std::optional<Vector2> position = walked.walk.at(state.time);
      if (position)
        sample.people.push_back({id + 1, *position, velocity_at(walked, state.time), walked.walk.radius});
    }
    diary.add(state.time, sample, robot);
  }
  return judge_contacts(diary.contacts(), searched, motion, known_until, limits);
}

}  // namespace bw
