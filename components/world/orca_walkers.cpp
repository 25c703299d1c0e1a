#include "components/world/orca_walkers.hpp"

#include <algorithm>

#include "components/local_planner/orca/orca.hpp"
#include "components/model/nearest_point.hpp"

namespace bw {
namespace {

constexpr double kRounding = 1e-9;  // [s]

// What stands within `reach` [m] of `position`, kept `radius` from.
std::vector<orca::Wall> walls_near(const StaticScene& scene, const Vector2& position, double reach,
                                   double radius) {
  std::vector<orca::Wall> walls;
  const auto add = [&](const Segment& core, double extent) {
    if ((nearest_point(core, position) - position).norm() <= reach + extent)
      walls.push_back({core, radius + extent});
  };
  for (const Segment& segment : scene.segments()) add(segment, 0.0);
  for (const Disc& disc : scene.discs()) add({disc.center, disc.center}, disc.radius);
  if (scene.grid()) {
    for (const Segment& edge : scene.grid()->edges_within(position, reach)) add(edge, 0.0);
  }
  return walls;
}

}  // namespace

OrcaWalkers::OrcaWalkers(const OrcaWalkersOptions& options, const StaticScene& scene, std::uint32_t first_id,
                         Random random)
    : options_(options), scene_(scene), walkers_(walkers_at_start<GoalWalker>(options, first_id, random)) {}

bool OrcaWalkers::displace(std::uint32_t id, const Vector2& by) { return displace_one(walkers_, id, by); }

Vector2 OrcaWalkers::decision_of(const GoalWalker& walker, const Surroundings& surroundings) const {
  const Person& me = walker.body;
  orca::Agent agent{.position = me.position,
                    .velocity = me.velocity,
                    .radius = me.radius + options_.kMargin,
                    .wanted = {0.0, 0.0},
                    .v_max = walker.speed};
  const Vector2 to_goal = walker.goal - me.position;
  const double distance = to_goal.norm();
  if (!walker.arrived && distance > 0.0) agent.wanted = to_goal * (walker.speed / std::max(distance, 1.0));
  std::vector<orca::Neighbour> others;
  const auto add = [&](const auto& body, double share) {
    others.push_back({body.position, body.velocity, body.radius + options_.kMargin, share});
  };
  for (const GoalWalker& other : walkers_) {
    if (&other != &walker) add(other.body, 0.5);
  }
  for (const Person& other : surroundings.others) add(other, 1.0);
  for (const RobotBody& robot : surroundings.robots) add(robot, options_.robots_share ? 0.5 : 1.0);
  const double reach = walker.speed * options_.kWallHorizon + me.radius;
  return orca::advise(agent, others, walls_near(scene_, me.position, reach, me.radius),
                      {.neighbour_range = options_.kNeighbourRange,
                       .max_neighbours = options_.kMaxNeighbours,
                       .horizon = options_.kHorizon,
                       .wall_horizon = options_.kWallHorizon,
                       .time_step = options_.kPeriod})
      .velocity;
}

void OrcaWalkers::decide(const Surroundings& surroundings) {
  // All from one instant.
  std::vector<Vector2> velocities;
  velocities.reserve(walkers_.size());
  for (const GoalWalker& walker : walkers_) velocities.push_back(decision_of(walker, surroundings));
  for (std::size_t i = 0; i < walkers_.size(); ++i) walkers_[i].body.velocity = velocities[i];
}

void OrcaWalkers::step(double dt, const Surroundings& surroundings, std::vector<Person>& people) {
  if (dt > 0.0 && until_decision_ <= kRounding) {
    decide(surroundings);
    until_decision_ = options_.kPeriod;
  }
  until_decision_ -= dt;
  for (GoalWalker& walker : walkers_) {
    walker.body.position += dt * walker.body.velocity;
    if (!walker.arrived) turn_at_goal(walker, options_);
    people.push_back(walker.body);
  }
}

}  // namespace bw
