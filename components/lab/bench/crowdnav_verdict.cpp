#include "components/lab/bench/crowdnav_verdict.hpp"

#include <algorithm>

namespace bw {

std::vector<JudgedContact> judge_crowdnav(const std::vector<possible::MotionState>& motion,
                                          const CrowdNavWalks& walks, const Limits& limits) {
  if (motion.empty() || walks.empty()) return {};
  possible::SearchScene searched;
  searched.outer_radius = searched.inner_radius = kCrowdNavRadius;
  searched.walks.resize(walks.front().size());
  for (std::size_t step = 0; step < walks.size(); ++step) {
    for (std::size_t i = 0; i < searched.walks.size(); ++i) {
      searched.walks[i].radius = kCrowdNavRadius;
      searched.walks[i].positions.push_back(
          {static_cast<double>(step) * kCrowdNavStep, walks[step][i].position});
    }
  }
  const double known_until = searched.walks.front().positions.back().time;
  ContactDiary diary;
  Footprint robot;
  robot.radius = kCrowdNavRadius;
  for (const possible::MotionState& state : motion) {
    TruthSample sample;
    sample.X_MB = state.pose;
    sample.twist = state.twist;
    // The velocity of a step is that which its end has.
    const auto step = static_cast<std::size_t>(std::max(0.0, state.time / kCrowdNavStep - 1e-9)) + 1;
    for (std::size_t i = 0; i < searched.walks.size(); ++i) {
      const std::optional<Vector2> position = searched.walks[i].at(state.time);
      if (!position) continue;
      const Vector2 velocity = walks[std::min(step, walks.size() - 1)][i].velocity;
      sample.people.push_back({static_cast<std::uint32_t>(i) + 1, *position, velocity, kCrowdNavRadius});
    }
    diary.add(state.time, sample, robot);
  }
  return judge_contacts(diary.contacts(), searched, motion, known_until, limits);
}

}  // namespace bw
