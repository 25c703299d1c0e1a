#include "components/model/sweep_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace bw {
namespace {

// Seven intervals: 26 ms of a revolution at 5.5 Hz, 14 ms at 10 Hz, about as often as odometry comes.
constexpr std::size_t kKnots = 8;

struct Knot {
  double at = 0.0;  ///< the beam that was taken then, of which there may be a part
  Pose2 X_FB;
};

std::vector<Knot> known_knots(const LaserSweep& sweep, const PoseAtTime& X_FB_at) {
  std::vector<Knot> known;
  const auto last = static_cast<double>(sweep.ranges.size() - 1);
  for (std::size_t i = 0; i < kKnots; ++i) {
    const double beam = last * static_cast<double>(i) / static_cast<double>(kKnots - 1);
    const auto X_FB = X_FB_at(sweep.time + Duration::seconds(taken_after(sweep, beam)));
    if (X_FB && is_finite(*X_FB)) known.push_back({beam, *X_FB});
  }
  return known;
}

}  // namespace

// With the body velocity held, a point of the plane taken for a complex number has gone (e^(i theta) - 1) /
// (i theta) of the straight path after a rotation by theta; the quotient of two of these is what is left
// here.
Pose2 pose_between(const Pose2& a, const Pose2& b, double share) {
  const Pose2 X_ab = inverse(a) * b;
  const double half = X_ab.theta / 2.0;
  const double gone = std::abs(half) < 1e-6 ? share : std::sin(share * half) / std::sin(half);
  const Vector2 position = gone * rotate({0.0, 0.0, (share - 1.0) * half}, X_ab.position());
  return a * Pose2{position.x(), position.y(), wrap_angle(share * X_ab.theta)};
}

std::vector<Pose2> beam_poses(const LaserSweep& sweep, const Pose2& X_BL, const PoseAtTime& X_FB_at) {
  if (sweep.time_increment == 0.0 || sweep.ranges.size() < 2) return {};
  const std::vector<Knot> known = known_knots(sweep, X_FB_at);
  if (known.size() < 2) return {};
  const auto between = [&](const Knot& a, const Knot& b, double beam) {
    return pose_between(a.X_FB, b.X_FB, (beam - a.at) / (b.at - a.at)) * X_BL;
  };
  std::vector<Pose2> poses;
  poses.reserve(sweep.ranges.size());
  for (std::size_t i = 0; i < sweep.ranges.size(); ++i) {
    const auto beam = static_cast<double>(i);
    const auto next = std::ranges::find_if(known, [&](const Knot& knot) { return knot.at > beam; });
    const bool is_outside = next == known.begin() || next == known.end();
    poses.push_back(is_outside ? between(known.front(), known.back(), beam)
                               : between(*(next - 1), *next, beam));
  }
  return poses;
}

}  // namespace bw
