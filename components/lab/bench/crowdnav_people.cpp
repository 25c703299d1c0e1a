#include "components/lab/bench/crowdnav_people.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/orca/orca.hpp"

namespace bw {
namespace {

constexpr double kTopSpeed = 1.0;    // [m/s] that anybody wants
constexpr double kWidening = 0.01;   // [m]
constexpr double kOtherGoals = 5.0;  // [s] between times at which goals change
constexpr double kOtherGoal = 0.5;   // chance of each

CrowdNavAgent agent_of(const CrowdNavPerson& person, std::uint32_t id) {
  return {person.start, {0.0, 0.0}, person.radius, person.speed, id, person.look};
}

}  // namespace

Vector2 crowdnav_orca(const CrowdNavAgent& self, const Vector2& goal,
                      const std::vector<CrowdNavAgent>& others, double safety_space, std::size_t neighbours) {
  const Vector2 to_goal = goal - self.position;
  const double distance = to_goal.norm();
  const orca::Agent agent{.position = self.position,
                          .velocity = self.velocity,
                          .radius = self.radius + kWidening + safety_space,
                          .wanted = distance > kTopSpeed ? Vector2(to_goal / distance) : to_goal,
                          .v_max = self.speed};
  std::vector<orca::Neighbour> around;
  around.reserve(others.size());
  for (const CrowdNavAgent& other : others)
    around.push_back({other.position, other.velocity, other.radius + kWidening + safety_space, 0.5});
  return orca::advise(agent, around, {},
                      {.neighbour_range = self.look,
                       .max_neighbours = static_cast<std::int64_t>(neighbours),
                       .time_step = kCrowdNavStep})
      .velocity;
}

Vector2 crowdnav_social_force(const CrowdNavAgent& self, const Vector2& goal,
                              const std::vector<CrowdNavAgent>& others) {
  constexpr double kRelaxation = 1.0;  // [s]
  constexpr double kStrength = 2.0;    // [m/s^2]
  constexpr double kRange = 1.0;       // [m]
  const Vector2 wanted = self.speed * (goal - self.position).normalized();
  Vector2 force = (wanted - self.velocity) / kRelaxation;
  for (const CrowdNavAgent& other : others) {
    const Vector2 away = self.position - other.position;
    const double gap = away.norm() - self.radius - other.radius;
    force += kStrength * std::exp(-gap / kRange) * away.normalized();
  }
  const Vector2 velocity = self.velocity + kCrowdNavStep * force;
  return velocity.norm() > self.speed ? Vector2(self.speed * velocity.normalized()) : velocity;
}

CrowdNavPeople::CrowdNavPeople(const CrowdNavScene& scene) : rules_(scene.rules), random_(scene.random) {
  for (const CrowdNavPerson& person : scene.people) {
    agents_.push_back(agent_of(person, next_id_++));
    goals_.push_back(person.goal);
    newest_look_ = person.look;
  }
  beliefs_.resize(agents_.size());
  meet();
}

// Everybody looks as far as who came last: the published simulation shares that number.
void CrowdNavPeople::meet() {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (!beliefs_[i].radii.empty()) continue;
    beliefs_[i].look = newest_look_;
    for (std::size_t j = 0; j < agents_.size(); ++j)
      if (j != i) beliefs_[i].radii.push_back(agents_[j].radius);
  }
}

std::vector<Vector2> CrowdNavPeople::decide(const CrowdNavAgent* robot) const {
  std::vector<Vector2> velocities;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    std::vector<CrowdNavAgent> others;
    for (std::size_t j = 0; j < agents_.size(); ++j) {
      if (j == i) continue;
      others.push_back(agents_[j]);
      others.back().radius = beliefs_[i].radii[others.size() - 1];
    }
    if (robot) others.push_back(*robot);
    CrowdNavAgent self = agents_[i];
    self.look = beliefs_[i].look;
    velocities.push_back(crowdnav_orca(self, goals_[i], others, rules_.people_margin, rules_.neighbours));
  }
  return velocities;
}

void CrowdNavPeople::walk(const std::vector<Vector2>& velocities, double duration) {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    agents_[i].velocity = velocities[i];
    agents_[i].position += duration * velocities[i];
  }
}

CrowdNavPerson CrowdNavPeople::as_person(std::size_t i) const {
  return {agents_[i].position, goals_[i], agents_[i].radius, agents_[i].speed};
}

std::vector<CrowdNavPerson> CrowdNavPeople::all(const CrowdNavPerson& robot) const {
  std::vector<CrowdNavPerson> there{robot};
  for (std::size_t i = 0; i < agents_.size(); ++i) there.push_back(as_person(i));
  return there;
}

std::vector<CrowdNavAgent> CrowdNavPeople::renew(double time, const CrowdNavPerson& robot) {
  std::vector<CrowdNavAgent> gone;
  if (rules_.mixed && std::fmod(time, kOtherGoals) == 0.0) {
    for (std::size_t i = 0; i < agents_.size(); ++i) {
      if (random_.uniform() > kOtherGoal) continue;
      std::vector<CrowdNavPerson> others = all(robot);
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      goals_[i] = crowdnav_other_goal(random_, as_person(i), others);
    }
  }
  for (std::size_t i = 0; rules_.newcomers && i < agents_.size(); ++i) {
    if ((goals_[i] - agents_[i].position).norm() >= agents_[i].radius) continue;
    gone.push_back(agents_[i]);
    const CrowdNavPerson newcomer = crowdnav_newcomer(random_, rules_.mixed, all(robot));
    agents_[i] = agent_of(newcomer, next_id_++);
    goals_[i] = newcomer.goal;
    beliefs_[i] = {};
    newest_look_ = newcomer.look;
  }
  meet();
  return gone;
}

}  // namespace bw
