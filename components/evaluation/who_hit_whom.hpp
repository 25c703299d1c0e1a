// Who hit whom at a contact (possible/theory.md 8.10). Pure geometry of one instant.
#pragma once

#include <array>

#include "runtime/base/pose2.hpp"

namespace bw {

enum class WhoHit {
  robot_standing,  ///< it moved no faster than kStandingSpeed
  robot_closing,  ///< its own velocity brings it as much towards the person as theirs brings them towards it, or more
  person_ahead,  ///< the person does more, from within 45 degrees of the robot's direction of travel
  person_side,   ///< from 45 to 135 degrees
  person_behind  ///< from beyond 135 degrees
};
inline constexpr std::array kAllWhoHit = {WhoHit::robot_closing, WhoHit::person_ahead, WhoHit::person_side,
                                          WhoHit::person_behind, WhoHit::robot_standing};

/// A contact slower than this is the other's doing [m/s]: the same as that of contacts at speed.
inline constexpr double kStandingSpeed = 0.1;

struct Closing {
  WhoHit who = WhoHit::robot_standing;
  double robot = 0.0;    ///< speed of the robot towards the person's centre [m/s]; negative: away
  double person = 0.0;   ///< of the person towards the robot's centre [m/s]
  double bearing = 0.0;  ///< of the person, from the robot's direction of travel [rad]
};

/// Pose and twist of the robot, centre and velocity of the person, in one frame. A robot that drives backward
/// travels where its back points. Centres in one position: the person is straight ahead.
Closing who_hit_whom(const Pose2& robot, const Twist2& twist, const Vector2& person, const Vector2& velocity);

/// "robot_closing", as in JSON.
const char* text_of(WhoHit who);

}  // namespace bw
