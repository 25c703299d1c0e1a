// Whether the robot can drive straight from one place to another among bodies.
#pragma once

#include <vector>

#include "components/local_planner/homotopy/obstacle_bodies.hpp"

namespace bw::homotopy {

class EdgeCheck {
 public:
  /// `bodies` must outlive the check. Clearance [m]: the gap that is kept.
  EdgeCheck(const Course& course, const std::vector<Body>& bodies, double clearance);

  /// The segment keeps the clearance from all bodies; movers with `motion` where they are when a robot at
  /// v_max passes. A body that the start (goal) is already closer to may be approached by half a robot radius
  /// more on an edge from (to) there: a way round what stands right ahead begins by coming closer.
  bool clear(const Vector2& from, const Vector2& to) const;

 private:
  struct Box {
    Vector2 low, high;
  };
  struct Watched {
    const Body* body;
    Box box;          // of the parts
    double at_start;  // gap [m] between robot and body there
    double at_goal;
  };
  double gap(const Body& body, const Vector2& from, const Vector2& to, double enough) const;

  Course course_;
  double clearance_;
  std::vector<Watched> watched_;
};

}  // namespace bw::homotopy
