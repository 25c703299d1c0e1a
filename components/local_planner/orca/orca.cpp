#include "components/local_planner/orca/orca.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "components/model/nearest_point.hpp"

namespace bw::orca {
namespace {

// Nearest first; what is equally near by all that tells neighbours apart.
std::vector<Neighbour> nearest(const Agent& agent, std::vector<Neighbour> list, const Rule& rule) {
  const auto distance2 = [&](const Neighbour& n) { return (n.position - agent.position).squaredNorm(); };
  std::erase_if(list, [&](const Neighbour& n) {
    return !(distance2(n) < rule.neighbour_range * rule.neighbour_range);
  });
  const auto key = [&](const Neighbour& n) {
    return std::tuple(distance2(n), n.position.x(), n.position.y(), n.velocity.x(), n.velocity.y(), n.radius,
                      n.share);
  };
  std::sort(list.begin(), list.end(),
            [&](const Neighbour& a, const Neighbour& b) { return key(a) < key(b); });
  if (static_cast<std::int64_t>(list.size()) > rule.max_neighbours)
    list.resize(static_cast<std::size_t>(rule.max_neighbours));
  return list;
}

std::vector<Wall> nearest(const Agent& agent, std::vector<Wall> list) {
  const auto key = [&](const Wall& w) {
    const double distance2 = (nearest_point(w.core, agent.position) - agent.position).squaredNorm();
    return std::tuple(distance2, w.core.a.x(), w.core.a.y(), w.core.b.x(), w.core.b.y(), w.radius);
  };
  std::sort(list.begin(), list.end(), [&](const Wall& a, const Wall& b) { return key(a) < key(b); });
  return list;
}

}  // namespace

Advice advise(const Agent& agent, const std::vector<Neighbour>& neighbours, const std::vector<Wall>& walls,
              const Rule& rule) {
  std::vector<HalfPlane> half_planes;
  for (const Wall& wall : nearest(agent, walls)) {
    const Segment seen{wall.core.a - agent.position, wall.core.b - agent.position};
    half_planes.push_back(clear_of(seen, wall.radius, agent.velocity, rule.wall_horizon));
  }
  for (const Neighbour& n : nearest(agent, neighbours, rule)) {
    const MovingDisc seen{n.position - agent.position, n.velocity, agent.radius + n.radius};
    half_planes.push_back(clear_of(seen, agent.velocity, n.share, rule.horizon, rule.time_step));
  }
  const Choice choice = best_velocity(half_planes, walls.size(), agent.wanted, agent.v_max);
  return {choice.velocity, choice.free, std::move(half_planes)};
}

}  // namespace bw::orca
