#include "tests/components/safety/monitor_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "components/model/stopping.hpp"
#include "tests/components/safety/monitor_driver.hpp"

namespace bw::safety::test {
namespace {

constexpr double kStanding = 0.02;   // [m/s]
constexpr double kOnTheSpot = 0.2;   // [s] that base_link stands
constexpr double kAhead = 0.6;       // [rad], of the direction it goes
constexpr double kRemembered = 1.0;  // [s]
constexpr double kGraze = 0.03;      // [m]: what is touched no deeper than that may be noise
constexpr double kGentle = 0.05;     // [m/s]
constexpr double kBraking = 0.01;    // [s] of the stop that is reckoned

/// Where a robot touches a thing: at the corner that is in it, else at that end of it which is deeper in the
/// outline.
Vector2 touched(const Footprint& outline, const Pose2& X_WB, const Capsule& thing) {
  for (const Vector2& corner : outline.polygon) {
    const Vector2 at = X_WB * corner;
    if (distance_to(at, thing).distance < 0.0) return point_near(thing, at);
  }
  const auto of_end = [&](const Vector2& end) {
    return distance_to(outline, X_WB, Capsule{end, end, thing.radius});
  };
  const FootprintDistance a = of_end(thing.a), b = of_end(thing.b);
  return a.distance <= b.distance ? thing.a + thing.radius * a.gradient : thing.b + thing.radius * b.gradient;
}

/// Of the robot itself [m/s].
double closing(const FootprintDistance& d, const Pose2& X_WB, const Twist2& twist) {
  return -(d.gradient.dot(twist.v * direction(X_WB.theta)) + d.by_theta * twist.omega);
}

}  // namespace

Judge::Judge(const Scene& scene, const Robot& robot, const Laser& laser, double reaction_time)
    : scene_(scene),
      robot_(robot),
      outline_(robot.outline()),
      laser_(laser),
      reaction_time_(reaction_time),
      contacts_(scene.things.size()) {
  const auto& n = scene.numbers;
  const double braking = wheel_of({n[kSpeed], n[kTurnRate]}) / n[kDeceleration];
  stopping_ = std::max(kRemembered, n[kPeriod] * (1.0 + n[kSweepShare]) + n[kAge] + reaction_time + braking);
}

/// Or has, while the sweeps are remembered.
bool Judge::moves(std::size_t thing, double t) const {
  return scene_.things[thing].speed() > 0.0 && t < scene_.things[thing].until + stopping_;
}

double Judge::wheel_of(const Twist2& twist) const {
  return std::abs(twist.v) + 0.5 * robot_.wheel_separation * std::abs(twist.omega);
}

void Judge::heard(double t, Laser::Sweep sweep, const Pose2& X_WB, const Twist2& twist) {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (!moves(i, t)) continue;
    Capsule person = shape_of(scene_.things[i], sweep.middle());
    const bool is_shown = laser_.shows(sweep, point_near(person, sweep.X_WL.front().position()));
    person.radius -= kGraze;
    if (!is_shown || !would_touch(person, X_WB, twist))
      contacts_[i].in_path_at = kNever;
    else
      contacts_[i].in_path_at = std::min(contacts_[i].in_path_at, t);
  }
  sweeps_.push_back(std::move(sweep));
}

void Judge::look(double t, const Pose2& X_WB, const Twist2& twist, const std::vector<Capsule>& things,
                 Result& result) {
  const double braked = robot_.limits.stop_deceleration * (t - looked_at_);
  looked_at_ = t;
  if (std::abs(twist.v) >= kStanding) drove_at_ = t;
  while (!sweeps_.empty() && sweeps_.front().middle() < t - stopping_) sweeps_.pop_front();
  for (std::size_t i = 0; i < things.size(); ++i) {
    Contact& contact = contacts_[i];
    contact.wheel =
        t < contact.in_path_at + reaction_time_ ? wheel_of(twist) : std::max(0.0, contact.wheel - braked);
    if (gap_to(outline_, X_WB, things[i], 0.0) >= 0.0) {
      contact.kind = nullptr;
      continue;
    }
    const FootprintDistance d = distance_to(outline_, X_WB, things[i]);
    const bool begins = contact.kind == nullptr;
    if (begins)
      contact.kind = moves(i, t) ? kind_of_person(contact, t, twist)
                                 : kind_of(t, touched(outline_, X_WB, things[i]), X_WB, twist);
    if (contact.kind == &Result::rotated_into && drove_at_ == t)
      contact.kind = &Result::swept;  // it drives on
    double& worst = result.*contact.kind;
    // Who walks on is inside of the outline then, where no laser sees.
    if (begins || !moves(i, t)) worst = std::max(worst, closing(d, X_WB, twist));
  }
}

Judge::Kind Judge::kind_of(double t, const Vector2& position, const Pose2& X_WB, const Twist2& twist) const {
  const auto of_all = [&](double seconds, bool (Laser::*says)(const Laser::Sweep&, const Vector2&) const) {
    return !sweeps_.empty() && std::ranges::all_of(sweeps_, [&](const auto& sweep) {
      return sweep.middle() < t - seconds || (laser_.*says)(sweep, position);
    });
  };
  if (of_all(stopping_, &Laser::shows)) return &Result::worst;
  if (!of_all(kRemembered, &Laser::is_blind_to)) return &Result::hidden;
  if (t >= drove_at_ + kOnTheSpot) return &Result::rotated_into;
  const Vector2 offset = inverse(X_WB) * position;
  const bool is_ahead =
      std::abs(twist.v) >= outline_.radius * std::abs(twist.omega) &&
      std::abs(std::atan2(offset.y(), std::copysign(offset.x(), offset.x() * twist.v))) < kAhead;
  return is_ahead ? &Result::ahead : &Result::swept;
}

Judge::Kind Judge::kind_of_person(const Contact& contact, double t, const Twist2& twist) const {
  const bool must_brake = t >= contact.in_path_at + reaction_time_;
  return must_brake && wheel_of(twist) > contact.wheel + kStanding ? &Result::not_braked : &Result::walked_in;
}

bool Judge::would_touch(const Capsule& person, Pose2 X_WB, Twist2 twist) const {
  const double wheel = wheel_of(twist);
  const double seconds = reaction_time_ + wheel / robot_.limits.stop_deceleration;
  const double farthest = (std::abs(twist.v) + outline_.radius * std::abs(twist.omega)) * seconds;
  if (gap_to(outline_, X_WB, person, farthest) >= farthest) return false;
  for (double t = 0.0; t < seconds; t += kBraking) {
    if (gap_to(outline_, X_WB, person, 0.0) < 0.0 &&
        closing(distance_to(outline_, X_WB, person), X_WB, twist) > kGentle)
      return true;
    X_WB = advance_exact(X_WB, twist, kBraking);
    if (t < reaction_time_) continue;
    const WheelSpeeds wheels = to_wheel_speeds(twist, robot_.wheel_separation);
    twist = to_twist(brake(wheels, robot_.limits.stop_deceleration, kBraking), robot_.wheel_separation);
  }
  return false;
}

}  // namespace bw::safety::test
