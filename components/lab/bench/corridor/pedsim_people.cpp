#include "components/lab/bench/corridor/pedsim_people.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "components/model/nearest_point.hpp"

namespace bw {
namespace {

// Weights of the forces, and what each is made of.
constexpr double kSocialWeight = 2.1;
constexpr double kWallWeight = 3.0;
constexpr double kSocialRange = 2.0;   // [m]
constexpr double kMotionShare = 2.0;   // of the relative velocity beside the direction
constexpr double kInteraction = 0.35;  // range of the interaction for each unit of it
constexpr double kForwards = 3.0;      // angular sharpness along the interaction
constexpr double kSideways = 2.0;      // and across it
constexpr double kWallRange = 0.8;     // [m]
constexpr double kBody = 0.5;          // [m]
constexpr double kLookRange = 10.0;    // [m] along each axis
constexpr double kOncoming = 2.5;      // [rad] between headings
constexpr double kAhead = 0.3;         // [rad] from one's own
constexpr double kLook = 0.5;          // [m/s^2]

Vector2 left_of(const Vector2& v) { return {-v.y(), v.x()}; }

double angle_between(const Vector2& from, const Vector2& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

Vector2 towards(const Vector2& from, const Vector2& to) {
  const Vector2 d = to - from;
  return d.isZero() ? Vector2(0.0, 0.0) : Vector2(d.normalized());
}

// Of somebody at `offset`, `velocity` being one's own less theirs.
Vector2 social_force(const Vector2& offset, const Vector2& velocity) {
  const double distance = offset.norm();
  if (distance == 0.0 || distance > kSocialRange) return {0.0, 0.0};
  const Vector2 interaction = kMotionShare * velocity + offset / distance;
  const double strength = interaction.norm();
  if (strength == 0.0) return {0.0, 0.0};
  const Vector2 along = interaction / strength;
  const double range = kInteraction * strength;
  const double theta = angle_between(interaction, offset);
  const auto fades = [&](double sharpness) {
    const double angle = sharpness * range * theta;
    return std::exp(-distance / range - angle * angle);
  };
  const double side = theta > 0.0 ? 1.0 : theta < 0.0 ? -1.0 : 0.0;
  return -fades(kForwards) * along - side * fades(kSideways) * left_of(along);
}

// Off the nearest wall.
Vector2 wall_force(const Vector2& position, const std::vector<Segment>& walls) {
  double nearest = std::numeric_limits<double>::infinity();
  Vector2 away{0.0, 0.0};
  for (const Segment& wall : walls) {
    const Vector2 offset = position - nearest_point(wall, position);
    if (offset.norm() >= nearest) continue;
    nearest = offset.norm();
    away = offset;
  }
  if (!(nearest > 0.0) || std::isinf(nearest)) return {0.0, 0.0};
  return std::exp(-(nearest - kBody) / kWallRange) * away / nearest;
}

// Which side those take who come towards one: +1 for each on the right, -1 on the left.
int oncoming(const Vector2& offset, const Vector2& velocity, const Vector2& wanted) {
  if (offset.cwiseAbs().maxCoeff() > kLookRange || velocity.isZero()) return 0;
  if (std::abs(angle_between(wanted, velocity)) <= kOncoming) return 0;
  const double bearing = angle_between(wanted, offset);
  if (std::abs(bearing) > kAhead) return 0;
  return bearing > 0.0 ? -1 : 1;
}

}  // namespace

Vector2 pedsim_force(const std::vector<PedsimPerson>& people, std::size_t i, const SceneRobot& robot,
                     const std::vector<Segment>& walls) {
  const PedsimPerson& self = people[i];
  const Vector2 wanted = towards(self.position, self.goal);
  Vector2 social{0.0, 0.0};
  int count = 0;
  const auto meet = [&](const Vector2& position, const Vector2& velocity) {
    const Vector2 offset = position - self.position;
    social += social_force(offset, self.velocity - velocity);
    count += oncoming(offset, velocity, wanted);
  };
  for (std::size_t j = 0; j < people.size(); ++j)
    if (j != i) meet(people[j].position, people[j].velocity);
  meet(robot.position, robot.velocity);
  const double side = count > 0 ? 1.0 : count < 0 ? -1.0 : 0.0;
  return self.speed * wanted + kSocialWeight * social + kWallWeight * wall_force(self.position, walls) +
         side * kLook * left_of(wanted);
}

void pedsim_step(std::vector<PedsimPerson>& people, const SceneRobot& robot,
                 const std::vector<Segment>& walls) {
  std::vector<Vector2> forces;
  for (std::size_t i = 0; i < people.size(); ++i) forces.push_back(pedsim_force(people, i, robot, walls));
  for (std::size_t i = 0; i < people.size(); ++i) {
    PedsimPerson& person = people[i];
    person.velocity += kSceneStep * forces[i];
    const double speed = person.velocity.norm();
    if (speed > person.speed) person.velocity *= person.speed / speed;
    person.position += kSceneStep * person.velocity;
    if ((person.goal - person.position).norm() < kPedsimArrived) std::swap(person.goal, person.other_goal);
  }
}

PedsimPeople::PedsimPeople(std::vector<PedsimPerson> people, std::vector<Segment> walls, double radius)
    : people_(std::move(people)), walls_(std::move(walls)) {
  for (std::size_t i = 0; i < people_.size(); ++i)
    discs_.push_back({.id = static_cast<std::uint32_t>(i), .radius = radius});
  place();
}

void PedsimPeople::step(const SceneRobot& robot) {
  pedsim_step(people_, robot, walls_);
  place();
}

void PedsimPeople::place() {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    discs_[i].position = people_[i].position;
    discs_[i].velocity = people_[i].velocity;
  }
}

}  // namespace bw
