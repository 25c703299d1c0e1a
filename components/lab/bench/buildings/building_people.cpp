#include "components/lab/bench/buildings/building_people.hpp"

#include <algorithm>
#include <cmath>

namespace bw::buildings {
namespace {

constexpr double kFromRobot = 0.6;  // robot and leg touch at 0.51 m [m]
constexpr double kFromStart = 2.0;  // of the robot, at first [m]
constexpr double kAsideRate = 1.0;  // about the robot, of who is in its way: else they went before it [rad/s]
constexpr double kMinute = 60.0;    // [s]
constexpr double kMinuteShare = 0.3;  // of those who arrive

// As in the tests of the people's perception: no statues.
constexpr LegOptions kLegs{.sway = 0.003, .shift_every = 15.0};

}  // namespace

BuildingPeople::BuildingPeople(const Building& building, const WallIndex& walls, int count, Random random)
    : walls_(walls), cells_(building, walls), random_(random), legs_(kLegs) {
  const Vector2& start = building.route.front();
  for (int i = 0; i < count; ++i) {
    Walker walker;
    walker.body.id = static_cast<std::uint32_t>(i + 1);
    walker.speed = random_.uniform(0.8, 1.4);
    do {
      walker.body.position = cells_.drawn_place(random_);
    } while ((walker.body.position - start).norm() < kFromStart);
    walkers_.push_back(walker);
  }
}

bool BuildingPeople::has_room(const Vector2& place) const {
  return walls_.clearance(place, kPersonClearance) >= kPersonClearance;
}

/// Where its way leads it.
Vector2 BuildingPeople::walked(Walker& walker, double dt) {
  const Vector2& here = walker.body.position;
  if (walker.stands > 0.0) {
    walker.stands -= dt;
    return here;
  }
  if (walker.way.empty()) {
    walker.way = cells_.way(here, cells_.drawn_place(random_));
    return here;
  }
  const Vector2 corner = walker.way.back();
  const double left = (corner - here).norm();
  if (left > walker.speed * dt) return here + (corner - here) * (walker.speed * dt / left);
  walker.way.pop_back();
  if (walker.way.empty())
    walker.stands = random_.uniform() < kMinuteShare ? kMinute : random_.uniform(0.0, 5.0);
  return corner;
}

bool BuildingPeople::move(Walker& walker, double dt, const Vector2& robot) {
  const Vector2 before = walker.body.position;
  Vector2 next = walked(walker, dt);
  const Vector2 from_robot = next - robot;
  const bool is_in_its_way = from_robot.norm() < kFromRobot;
  if (is_in_its_way) {
    const double angle = std::atan2(from_robot.y(), from_robot.x()) + kAsideRate * dt;
    next = robot + kFromRobot * direction(angle);
    if (!has_room(next)) return false;
  } else if (!has_room(next)) {  // it was pushed off its way, and a wall stands between
    next = cells_.nearest_center(before);
    if (!walker.way.empty()) walker.way = cells_.way(next, walker.way.front());
  }
  walker.body.position = next;
  walker.body.velocity = (next - before) / dt;
  return true;
}

void BuildingPeople::step(double dt, const Vector2& robot) {
  people_.clear();
  for (Walker& walker : walkers_) {
    if (move(walker, dt, robot)) people_.push_back(walker.body);
  }
  legs_.step(dt, people_);
}

}  // namespace bw::buildings
