#include "components/world/legs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw {
namespace {

constexpr double kStanding = 0.05;      // [m/s], slower than this nobody turns
constexpr double kSwayTime = 1.0;       // a leg's wandering is forgotten after so long [s]
constexpr double kHomeTime = 0.2;       // who walks off forgets within it where their feet were set [s]
constexpr double kStepTime = 0.4;       // of setting a foot aside [s]
constexpr double kLeastWait = 1.0 / 3;  // shares of the mean time between such steps
constexpr double kMaxWait = 5.0 / 3;
constexpr double kFarthestFoot = 0.15;  // from where it belongs [m]
constexpr double kWidestStand = 0.45;   // [m]

}  // namespace

void Legs::step(double dt, const std::vector<Person>& people) {
  for (const Person& person : people) {
    const double speed = person.velocity.norm();
    Gait& gait = gaits_[person.id];
    gait.walked += speed * dt;
    if (speed > kStanding) {
      gait.facing = person.velocity / speed;
      for (Foot& foot : gait.feet) come_home(dt, foot);
      gait.until_next = 0.0;
    } else if (options_.sway > 0.0 || options_.shift_every > 0.0) {
      stand(dt, person.id, gait);
    }
  }
}

void Legs::come_home(double dt, Foot& foot) {
  const double kept = std::exp(-dt / kHomeTime);
  for (Vector2* position : {&foot.from, &foot.to, &foot.wander}) *position *= kept;
}

void Legs::stand(double dt, std::uint32_t id, Gait& gait) const {
  if (!gait.random) gait.random.emplace(id);
  const double kept = std::exp(-dt / kSwayTime);
  const double fresh = options_.sway * std::sqrt(1.0 - kept * kept);
  for (Foot& foot : gait.feet) {
    const double x = gait.random->normal();
    foot.wander = kept * foot.wander + fresh * Vector2(x, gait.random->normal());
  }
  if (options_.shift_every <= 0.0) return;
  gait.step = std::min(1.0, gait.step + dt / kStepTime);
  const bool has_waited = gait.until_next > 0.0 && gait.until_next <= dt;
  gait.until_next -= dt;
  if (has_waited) set_foot(gait);
  if (gait.until_next <= 0.0)
    gait.until_next = options_.shift_every * gait.random->uniform(kLeastWait, kMaxWait);
}

/// One foot goes somewhere new where it does not meet the other.
void Legs::set_foot(Gait& gait) const {
  const std::size_t leg = gait.random->uniform() < 0.5 ? 0 : 1;
  for (Foot& foot : gait.feet) foot.from = foot.to;
  gait.step = 0.0;
  Foot& foot = gait.feet[leg];
  for (int attempt = 0; attempt < 20; ++attempt) {
    const double distance = gait.random->uniform(0.05, 0.15);
    foot.to = foot.from + distance * direction(gait.random->uniform(-std::numbers::pi, std::numbers::pi));
    const Vector2 across{0.0, leg == 0 ? options_.separation : -options_.separation};
    const double apart = (across + foot.to - gait.feet[1 - leg].to).norm();
    if (foot.to.norm() <= kFarthestFoot && apart >= 2.0 * options_.radius && apart <= kWidestStand) return;
  }
  foot.to = foot.from;
}

std::vector<Disc> Legs::discs(const std::vector<Person>& people) const {
  std::vector<Disc> legs;
  legs.reserve(2 * people.size());
  const Gait none;
  for (const Person& person : people) {
    const auto found = gaits_.find(person.id);
    const Gait& gait = found == gaits_.end() ? none : found->second;
    const double share = std::min(1.0, person.velocity.norm() / options_.full_swing_speed);
    const double phase = 2.0 * std::numbers::pi * gait.walked / options_.stride;
    const Vector2 forward = gait.facing * (share * options_.swing * std::sin(phase));
    const Vector2 left_of_facing(-gait.facing.y(), gait.facing.x());
    const Vector2 left = left_of_facing * (options_.separation / 2.0);
    const auto beside = [&](std::size_t leg) {
      const Foot& foot = gait.feet[leg];
      const Vector2 offset = foot.from + gait.step * (foot.to - foot.from) + foot.wander;
      return Vector2(gait.facing * offset.x() + left_of_facing * offset.y());
    };
    legs.push_back({person.position + left + forward + beside(0), options_.radius});
    legs.push_back({person.position - left - forward + beside(1), options_.radius});
  }
  return legs;
}

}  // namespace bw
