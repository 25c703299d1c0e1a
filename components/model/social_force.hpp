// Forces per unit mass [m/s^2] that make people walk round one another and along walls.
// Social term: Moussaid et al. 2009; constants: libpedsim (world/README.md 7.6).
#pragma once

#include "runtime/base/field.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

struct SocialForceOptions {
  /// [s] time in which people regain the velocity they want
  static constexpr double kRelaxationTime = 0.5;
  /// weight of the pull to the goal
  static constexpr double kDesiredFactor = 1.0;
  double social_factor = 2.1;
  /// weight of keeping clear of walls (world/README.md 7.6)
  static constexpr double kObstacleFactor = 10.0;
  /// [m] distance over which the push of a wall fades; 0.2 for narrow doors (set by code alone)
  double obstacle_sigma = 0.8;
  /// weight of the relative velocity against the direction to somebody (world/README.md 7.6)
  static constexpr double kLambda = 2.0;
  /// reach of the force per unit of |D| (world/README.md 7.6)
  static constexpr double kGamma = 0.35;
  /// how narrow the sideways force is in angle (world/README.md 7.6)
  static constexpr double kN = 2.0;
  /// how narrow the slowing force is in angle (world/README.md 7.6)
  static constexpr double kNPrime = 3.0;

  /// [m/s^2] by which those of a group who are left behind are drawn to it
  static constexpr double kGroupPull = 3.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("social_factor", social_factor,
      {.min = 0,
       .max = 100,
       .doc = "weight of keeping clear of others; below 5 shoulders may brush head-on"});
    v.retired({"relaxation_time", "obstacle_factor", "obstacle_sigma"}, "a constant of social_force.hpp");
  }
};

/// desired_factor (v_desired - v) / relaxation_time.
Vector2 desired_force(const SocialForceOptions& options, const Vector2& desired_velocity,
                      const Vector2& velocity);

/// What j does to i, p_ij = p_j - p_i [m], v_ij = v_i - v_j [m/s]. Exactly ahead counts as left, so that both
/// pass on their right; zero for coinciding positions, where there is no direction.
Vector2 social_force(const SocialForceOptions& options, const Vector2& p_ij, const Vector2& v_ij);

/// Pull of a group of `members` [people] on one of them, `to_centre` [m] away from the middle of all: kGroupPull where that is
/// farther than a row of them is wide, (members - 1) / 2 m, else zero (Moussaid et al. 2010).
Vector2 group_force(const SocialForceOptions& options, const Vector2& to_centre, int members);

/// Push from the nearest wall point: kObstacleFactor exp(-(d - radius) / sigma) along `from_wall` (wall to
/// person).
Vector2 obstacle_force(const SocialForceOptions& options, const Vector2& from_wall, double radius);

}  // namespace bw
