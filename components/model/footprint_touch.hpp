// How far a polygon may move along an arc until it touches a point. Exact; base_link throughout.
#pragma once

#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

/// The first touch of a motion.
struct TouchOnArc {
  double distance = 0.0;  ///< of base_link [m]; rotating in place the angle [rad]; infinite: it never touches
  double lever = 1.0;     ///< distance of the side that touches over that [-]; of a rotation in place [m]
};

/// Of the convex counter-clockwise `polygon` with a point, on the arc of `twist` for one whole revolution at
/// most. Seen from the robot the point runs on a circle around the centre of the arc, and the touch is where
/// it crosses a side. A point inside: at once when the motion goes deeper, never when it leads out.
TouchOnArc first_touch(const Twist2& twist, const std::vector<Vector2>& polygon, const Vector2& point);

}  // namespace bw
