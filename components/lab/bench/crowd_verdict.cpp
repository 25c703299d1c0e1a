#include "components/lab/bench/crowd_verdict.hpp"

#include <cmath>

#include "components/lab/bench/crowd_walk.hpp"

namespace bw {

std::vector<JudgedContact> judge_crowd(const Scene& scene, const SceneFile& file,
                                       const CrowdEpisode& episode) {
  if (episode.contacts.empty()) return {};
  constexpr double kStep = 0.02;        // [s] of the drive's own looks
  constexpr double kLookedAfter = 6.0;  // [s] after a contact: longer than a search
  const ClosedLoop& rule = *file.closed_loop;
  double until = episode.contacts.back().time + kLookedAfter;
  possible::SearchScene searched;
  searched.outer_radius = searched.inner_radius = rule.robot_radius;
  for (const SceneObstacle& obstacle : scene.obstacles) {
    if (!obstacle.moves()) {
      searched.shapes.discs.push_back({obstacle.position, obstacle.radius});
      continue;
    }
    if (!episode.walks.empty()) continue;
    possible::Walk walk;
    walk.radius = obstacle.radius;
    for (int k = 0; k <= std::lround(until / kStep); ++k)
      walk.positions.push_back({kStep * k, position_at(obstacle, rule.box, kStep * k)});
    searched.walks.push_back(std::move(walk));
  }
  if (!episode.walks.empty()) {
    searched.walks = episode.walks;
    until = episode.walks.front().positions.back().time;
  }
  return judge_contacts(episode.contacts, searched, episode.states, until, file.limits);
}

}  // namespace bw
