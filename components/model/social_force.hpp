// Forces per unit mass [m/s^2] that make people walk round one another and along walls.
// Social term: Moussaid et al. 2009; constants: libpedsim (book 7.6).
#pragma once

#include "runtime/base/field.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

struct SocialForceOptions {
  double relaxation_time = 0.5;
  double desired_factor = 1.0;
  double social_factor = 2.1;
  double obstacle_factor = 10.0;
  double obstacle_sigma = 0.8;
  double lambda = 2.0;
  double gamma = 0.35;
  double n = 2.0;
  double n_prime = 3.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("relaxation_time", relaxation_time,
      {.unit = "s", .min = 0.05, .max = 10, .doc = "time in which people regain the velocity they want"});
    v("desired_factor", desired_factor,
      {.min = 0, .max = 100, .doc = "weight of the pull to the goal; raise it for people who hurry"});
    v("social_factor", social_factor,
      {.min = 0,
       .max = 100,
       .doc = "weight of keeping clear of others; below 5 shoulders may brush head-on"});
    v("obstacle_factor", obstacle_factor, {.min = 0, .max = 100, .doc = "weight of keeping clear of walls"});
    v("obstacle_sigma", obstacle_sigma,
      {.unit = "m",
       .min = 0.01,
       .max = 10,
       .doc = "distance over which the push of a wall fades; 0.2 for narrow doors"});
    v("lambda", lambda,
      {.min = 0,
       .max = 100,
       .doc = "weight of the relative velocity against the direction to somebody (book 7.6)"});
    v("gamma", gamma,
      {.min = 0.01,
       .max = 10,
       .doc = "reach of the force per unit of |D| (book 7.6); raise it for people who keep clear earlier"});
    v("n", n, {.min = 0, .max = 100, .doc = "how narrow the sideways force is in angle (book 7.6)"});
    v("n_prime", n_prime,
      {.min = 0, .max = 100, .doc = "how narrow the slowing force is in angle (book 7.6)"});
  }
};

/// desired_factor (v_desired - v) / relaxation_time.
Vector2 desired_force(const SocialForceOptions& options, const Vector2& desired_velocity,
                      const Vector2& velocity);

/// What j does to i, p_ij = p_j - p_i [m], v_ij = v_i - v_j [m/s]. Exactly ahead counts as left, so that both
/// pass on their right; zero for coinciding places, where there is no direction.
Vector2 social_force(const SocialForceOptions& options, const Vector2& p_ij, const Vector2& v_ij);

/// Push from the nearest wall point: obstacle_factor exp(-(d - radius) / sigma) along `from_wall` (wall to
/// person).
Vector2 obstacle_force(const SocialForceOptions& options, const Vector2& from_wall, double radius);

}  // namespace bw
