// The timed elastic band (theory.md 6.1): poses of base_link in the planning frame and the time between them.
#pragma once

#include <optional>
#include <vector>

#include "components/local_planner/teb/band_options.hpp"
#include "components/model/limits.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::teb {

/// Pose [m, m, rad] and the time [s] from it to the next one (0 for the last).
struct BandPose {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;
  double dt = 0.0;

  Pose2 pose() const { return {x, y, theta}; }
  Vector2 position() const { return {x, y}; }
};
static_assert(sizeof(BandPose) == 4 * sizeof(double), "the solver sees a pose as four doubles");

struct Band {
  std::vector<BandPose> poses;  ///< one contiguous array: the parameter blocks of the solver
  double trust_radius = 0.0;    ///< where the last solve left the damping; 0: not solved yet

  bool empty() const { return poses.empty(); }
  std::size_t size() const { return poses.size(); }
  double duration() const;           ///< sum of the intervals [s]
  Pose2 pose_at(double time) const;  ///< at `time` [s] after the start, clamped to the ends
  bool is_finite() const;
};

/// Point at fraction s in [0, 1] of the arc from a to b (of the line, if they do not lie on one arc).
Pose2 interpolate(const Pose2& a, const Pose2& b, double s);

/// Where a clearance term looks at the robot: at share `fraction` of the path from `a` to `b`, states (x, y,
/// theta, ...), position and heading taken apart.
inline Pose2 between(const double* a, const double* b, double fraction) {
  const double rest = 1.0 - fraction;
  return {rest * a[0] + fraction * b[0], rest * a[1] + fraction * b[1],
          fraction == 0.0 ? a[2] : a[2] + fraction * wrap_angle(b[2] - a[2])};
}

/// A first band: from `start` along the rest of `path` (its last pose is the goal) at top speed. The path
/// holds at least one pose.
Band band_along(const std::vector<Pose2>& path, const Pose2& start, const Limits& limits,
                const BandOptions& options);

/// The same, but first rotating in place towards where the path leads; nothing when that is less than
/// `least_rotation` [rad] away.
std::optional<Band> band_rotating_first(const std::vector<Pose2>& path, const Pose2& start,
                                        const Limits& limits, const BandOptions& options,
                                        double least_rotation);

/// The same, driven backward; nothing unless the goal lies behind the robot and the base drives backward.
std::optional<Band> band_backward(const std::vector<Pose2>& path, const Pose2& start, const Limits& limits,
                                  const BandOptions& options);

/// The same motion sampled at `count` >= 2 equal intervals. The position as a function of time stays.
void resample(Band& band, std::size_t count);

/// Resamples when an interval or their mean has drifted from dt_ref, so that a mean interval stays within a
/// few percent of it.
void resize(Band& band, const BandOptions& options);

/// Warm start: cuts off what lies behind `start` within the next `horizon` seconds of the band, and starts
/// there. Returns how far `start` is from the band [m], a radian of heading counted as `kHeadingLength`.
double advance(Band& band, const Pose2& start, double horizon, const BandOptions& options);
inline constexpr double kHeadingLength = 0.3;

/// Moves the last pose to the goal, wherever the rest is.
void set_goal(Band& band, const Pose2& goal);

}  // namespace bw::teb
