#include "components/evaluation/who_hit_whom.hpp"

#include <cmath>
#include <numbers>

namespace bw {

Closing who_hit_whom(const Pose2& robot, const Twist2& twist, const Vector2& person,
                     const Vector2& velocity) {
  const Vector2 travel = direction(twist.v < 0.0 ? robot.theta + std::numbers::pi : robot.theta);
  const Vector2 apart = person - robot.position();
  const Vector2 towards = apart.squaredNorm() > 0.0 ? Vector2(apart.normalized()) : travel;
  Closing closing;
  closing.robot = twist.v * direction(robot.theta).dot(towards);
  closing.person = -velocity.dot(towards);
  closing.bearing = std::atan2(cross(travel, towards), travel.dot(towards));
  constexpr double kSector = std::numbers::pi / 4.0;
  const double aside = std::abs(closing.bearing);
  if (std::abs(twist.v) <= kStandingSpeed) {
    closing.who = WhoHit::robot_standing;
  } else if (closing.robot >= closing.person) {
    closing.who = WhoHit::robot_closing;
  } else if (aside <= kSector) {
    closing.who = WhoHit::person_ahead;
  } else {
    closing.who = aside <= 3.0 * kSector ? WhoHit::person_side : WhoHit::person_behind;
  }
  return closing;
}

const char* text_of(WhoHit who) {
  switch (who) {
    case WhoHit::robot_standing:
      return "robot_standing";
    case WhoHit::robot_closing:
      return "robot_closing";
    case WhoHit::person_ahead:
      return "person_ahead";
    case WhoHit::person_side:
      return "person_side";
    case WhoHit::person_behind:
      break;
  }
  return "person_behind";
}

}  // namespace bw
