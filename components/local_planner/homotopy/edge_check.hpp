// Whether the robot can drive straight from one position to another among bodies.
#pragma once

#include <vector>

#include "components/local_planner/homotopy/obstacle_bodies.hpp"
#include "components/model/capsule_index.hpp"

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
    double at_start;  // gap [m] between robot and body there, where it is below the clearance
    double at_goal;
    CapsuleIndex parts;  // of a body of many that stands
  };
  double gap(const Watched& watched, const Vector2& from, const Vector2& to, double wanted) const;
  double gap_to_many(const Watched& watched, const Segment& edge, double wanted) const;

  Course course_;
  double clearance_;
  std::vector<Watched> watched_;
};

}  // namespace bw::homotopy
