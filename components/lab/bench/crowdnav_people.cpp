#include "components/lab/bench/crowdnav_people.hpp"

#include "components/local_planner/orca/orca.hpp"

namespace bw {
namespace {

constexpr double kTopSpeed = 1.0;   // [m/s]
constexpr double kWidening = 0.01;  // [m]

}  // namespace

Vector2 crowdnav_orca(const CrowdNavAgent& self, const Vector2& goal,
                      const std::vector<CrowdNavAgent>& others, double safety_space) {
  const double radius = kCrowdNavRadius + kWidening + safety_space;
  const Vector2 to_goal = goal - self.position;
  const double distance = to_goal.norm();
  const orca::Agent agent{.position = self.position,
                          .velocity = self.velocity,
                          .radius = radius,
                          .wanted = distance > 1.0 ? Vector2(to_goal / distance) : to_goal,
                          .v_max = kTopSpeed};
  std::vector<orca::Neighbour> neighbours;
  neighbours.reserve(others.size());
  for (const CrowdNavAgent& other : others)
    neighbours.push_back({other.position, other.velocity, radius, 0.5});
  return orca::advise(agent, neighbours, {}, {.time_step = kCrowdNavStep}).velocity;
}

CrowdNavPeople::CrowdNavPeople(const CrowdNavScene& scene) {
  for (const CrowdNavPerson& person : scene.people) {
    agents_.push_back({person.start, {0.0, 0.0}});
    goals_.push_back(person.goal);
  }
}

std::vector<Vector2> CrowdNavPeople::decide(const CrowdNavAgent* robot) const {
  std::vector<Vector2> velocities;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    std::vector<CrowdNavAgent> others;
    for (std::size_t j = 0; j < agents_.size(); ++j)
      if (j != i) others.push_back(agents_[j]);
    if (robot) others.push_back(*robot);
    velocities.push_back(crowdnav_orca(agents_[i], goals_[i], others, 0.0));
  }
  return velocities;
}

void CrowdNavPeople::walk(const std::vector<Vector2>& velocities, double duration) {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    agents_[i].velocity = velocities[i];
    agents_[i].position += duration * velocities[i];
  }
}

}  // namespace bw
