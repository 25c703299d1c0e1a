#include "components/local_planner/carrot.hpp"

#include <limits>

#include "components/model/nearest_point.hpp"

namespace bw {

Vector2 carrot(const std::vector<Pose2>& plan, const Vector2& robot, double distance) {
  Vector2 end = plan.back().position();
  if (distance <= 0.0) return end;
  std::size_t nearest_leg = 0;
  Vector2 at = end;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < plan.size(); ++i) {
    const Vector2 p = nearest_point(Segment{plan[i].position(), plan[i + 1].position()}, robot);
    if ((robot - p).norm() >= smallest) continue;
    smallest = (robot - p).norm();
    nearest_leg = i;
    at = p;
  }
  for (std::size_t i = nearest_leg + 1; i < plan.size(); ++i) {
    const Vector2 next = plan[i].position();
    const double leg = (next - at).norm();
    if (leg > distance) return at + (distance / leg) * (next - at);
    distance -= leg;
    at = next;
  }
  return end;
}

}  // namespace bw
