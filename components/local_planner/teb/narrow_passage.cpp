#include "components/local_planner/teb/narrow_passage.hpp"

#include <algorithm>

#include "components/model/nearest_point.hpp"

namespace bw::teb {
namespace {

struct Side {
  Vector2 spot;  // of the axis of the obstacle, nearest to the robot
  double radius;
  bool is_left;
  ClearanceTerm* term;
};

double half_width(const Footprint& footprint) {
  if (!footprint.is_polygon()) return footprint.radius;
  const auto [right, left] =
      std::ranges::minmax_element(footprint.polygon, {}, [](const Vector2& p) { return p.y(); });
  return 0.5 * (left->y() - right->y());
}

// [m] at either side of a robot in the middle between two obstacles.
double room(const Side& one, const Side& other, double robot) {
  return 0.5 * ((one.spot - other.spot).norm() - one.radius - other.radius) - robot;
}

}  // namespace

void allow_narrow_passages(std::vector<ClearanceTerm>& terms, const Footprint& footprint,
                           const BandPose& from, const BandPose& to, double min_obstacle_dist, double least) {
  std::vector<Side> sides;
  for (ClearanceTerm& term : terms) {
    if (term.moving) continue;
    const Pose2 pose = between(&from.x, &to.x, term.fraction);
    const Vector2 spot = nearest_point(Segment{term.capsule.a, term.capsule.b}, pose.position());
    sides.push_back(
        {spot, term.capsule.radius, cross(direction(pose.theta), spot - pose.position()) > 0.0, &term});
  }
  const double robot = half_width(footprint);
  const auto is_gate = [&](const Side& left, const Side& right) {
    return std::ranges::none_of(sides, [&](const Side& other) {
      if (other.term == left.term || other.term == right.term || other.term->fraction != left.term->fraction)
        return false;
      // It stands between them when there is no passage at either side of it.
      return std::max(room(left, other, robot), room(other, right, robot)) < least;
    });
  };
  for (const Side& left : sides) {
    for (const Side& right : sides) {
      if (!left.is_left || right.is_left || left.term->fraction != right.term->fraction) continue;
      const double half = room(left, right, robot);
      if (half < least || half >= min_obstacle_dist || !is_gate(left, right)) continue;
      left.term->wanted = std::min(left.term->wanted, half);
      right.term->wanted = std::min(right.term->wanted, half);
    }
  }
}

}  // namespace bw::teb
