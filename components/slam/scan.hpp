// A sweep as SLAM uses it: surface points with normals to match by, and ranges to draw the map of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "components/model/laser_sweep.hpp"
#include "components/slam/slam_options.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::slam {

/// A place where beams ended, in base_link or in a submap.
struct SurfacePoint {
  float x = 0.0F;  ///< [m]
  float y = 0.0F;
  /// Direction of the wall's normal by its doubled angle, (cos 2a, sin 2a), times how straight the wall is
  /// there, 0 to 1: the sides of a wall are one, and normals can be averaged.
  float normal_cos2 = 0.0F;
  float normal_sin2 = 0.0F;

  Vector2 position() const { return {x, y}; }
};

/// Ranges of one sweep in two bytes each, as if all beams had been taken at the middle of the sweep: the turn
/// meanwhile is in the increment, motion along a beam in its range. What is left is motion across beams, a
/// few centimetres along the wall.
struct RangeImage {
  Pose2 X_BL;                    ///< at the middle of the sweep
  double angle_min = 0.0;        ///< [rad]
  double angle_increment = 0.0;  ///< [rad]
  std::vector<std::uint16_t> millimetres;

  static constexpr std::uint16_t kUnknown = 0;
  static constexpr std::uint16_t kNoReturn = 0xffff;
};

/// Index of the beam towards `p`, in the scanner's frame; nothing out of its view. From the first beam on, as the sweep
/// turns: a scanner may see more than half a circle.
std::optional<std::size_t> beam_towards(const RangeImage& image, const Vector2& p);

/// Share of the beams of `now`, of those that end where `then` looked, that end on what `then` saw, to 0.1 m and 2 % of the
/// range; X_TN: base_link now, in that of then. 1 where fewer than 30 do.
double seen_alike(const RangeImage& then, const RangeImage& now, const Pose2& X_TN);

struct Scan {
  Time time;
  std::vector<SurfacePoint> points;  ///< in base_link at `time`
  RangeImage ranges;
};

/// `sweep` without fault, X_FL and beam_poses in base_link at sweep.time. Points closer than half a
/// cell to the one before are left out. Hits beyond max_laser_range give no point and draw nothing.
Scan scan_of(const LaserSweep& sweep, const SlamOptions& options);

}  // namespace bw::slam
