// The judge of the monitor's property test: who touched what, in the true world, and could the laser see it?
#pragma once

#include <deque>
#include <vector>

#include "components/model/footprint_distance.hpp"
#include "components/model/robot.hpp"
#include "tests/components/safety/monitor_laser.hpp"
#include "tests/components/safety/monitor_simulation.hpp"

namespace bw::safety::test {

/// Times are of the world [s].
class Judge {
 public:
  Judge(const Scene& scene, const Robot& robot, const Laser& laser, double reaction_time);

  /// A sweep that the monitor got at `t` of a robot that moves with `twist` at X_WB.
  void heard(double t, Laser::Sweep sweep, const Pose2& X_WB, const Twist2& twist);
  /// After each step of the world; `things` as they are now.
  void look(double t, const Pose2& X_WB, const Twist2& twist, const std::vector<Capsule>& things,
            Result& result);

 private:
  using Kind = double Result::*;
  static constexpr double kNever = 1e9;

  /// Of a thing, and the robot.
  struct Contact {
    Kind kind = nullptr;         ///< while they touch
    double in_path_at = kNever;  ///< since when a stop begun at once would touch it where each sweep shows it
    double wheel = 0.0;          ///< fastest allowed by then, once the robot must brake [m/s]
  };
  bool moves(std::size_t thing, double t) const;
  double wheel_of(const Twist2& twist) const;
  Kind kind_of(double t, const Vector2& position, const Pose2& X_WB, const Twist2& twist) const;
  Kind kind_of_person(const Contact& contact, double t, const Twist2& twist) const;
  /// Whether a robot that brakes after the reaction time closes in on `person` and touches it at more than
  /// 0.05 m/s.
  bool would_touch(const Capsule& person, Pose2 X_WB, Twist2 twist) const;

  const Scene& scene_;
  const Robot& robot_;
  Footprint outline_;
  const Laser& laser_;
  double reaction_time_;
  double stopping_;  ///< [s] from a beam to rest, from top speed; a second at least
  std::vector<Contact> contacts_;
  std::deque<Laser::Sweep> sweeps_;
  double looked_at_ = 0.0;
  double drove_at_ = -kNever;  ///< faster than at rest, the last time
};

}  // namespace bw::safety::test
