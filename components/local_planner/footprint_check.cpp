#include "components/local_planner/footprint_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/mover_weight.hpp"

namespace bw {
namespace {

constexpr double kTimeStep = 0.1;  // [s] between tests of a standing robot: movers come to it
constexpr double kMostTestsPerSegment = 100.0;

double distance(const Vector2& p, const Vector2& a, const Vector2& b) {
  const Vector2 d = b - a;
  const double s = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-18), 0.0, 1.0);
  return (p - a - s * d).norm();
}

bool cross_each_other(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const double side_a = cross(d - c, a - c);
  const double side_b = cross(d - c, b - c);
  const double side_c = cross(b - a, c - a);
  const double side_d = cross(b - a, d - a);
  return side_a * side_b < 0.0 && side_c * side_d < 0.0;
}

// Signed distance of a counter-clockwise polygon to segment a-b; -1 mm is enough to say "contact".
double polygon_distance(const std::vector<Vector2>& polygon, const Vector2& a, const Vector2& b) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& p = polygon[i];
    const Vector2& q = polygon[(i + 1) % polygon.size()];
    if (cross_each_other(p, q, a, b)) return -1e-3;
    nearest = std::min({nearest, distance(p, a, b), distance(a, p, q), distance(b, p, q)});
    if ((p.y() > a.y()) != (q.y() > a.y()) &&
        a.x() < (q.x() - p.x()) * (a.y() - p.y()) / (q.y() - p.y()) + p.x()) {
      inside = !inside;
    }
  }
  return inside ? -nearest - 1e-3 : nearest;
}

double gap_to_movers(const Pose2& pose, double time, const Footprint& footprint,
                     const std::vector<Mover>& movers) {
  double gap = std::numeric_limits<double>::infinity();
  for (const Mover& m : movers) {
    if (!is_confirmed(m)) continue;
    const Vector2 p = m.position_at(time);
    gap = std::min(gap, gap_to(pose, footprint, p, p, m.radius));
  }
  return gap;
}

}  // namespace

double gap_to(const Pose2& pose, const Footprint& footprint, const Vector2& a, const Vector2& b,
              double radius) {
  const double disc_gap = distance(pose.position(), a, b) - footprint.radius - radius;
  if (footprint.polygon.size() < 3 || disc_gap > 0.0) return disc_gap;
  const Pose2 X_BO = inverse(pose);
  return polygon_distance(footprint.polygon, X_BO * a, X_BO * b) - radius;
}

double gap_to_statics(const Pose2& pose, const Footprint& footprint, const StaticObstacles& statics) {
  double gap = std::numeric_limits<double>::infinity();
  for (const Vector2& p : statics.points) gap = std::min(gap, gap_to(pose, footprint, p, p, 0.0));
  for (const Disc& d : statics.discs)
    gap = std::min(gap, gap_to(pose, footprint, d.center, d.center, d.radius));
  for (const Segment& s : statics.segments) gap = std::min(gap, gap_to(pose, footprint, s.a, s.b, 0.0));
  return gap;
}

double gap_at(const Pose2& pose, double time, const Footprint& footprint, const StaticObstacles& statics,
              const std::vector<Mover>& movers) {
  return std::min(gap_to_statics(pose, footprint, statics), gap_to_movers(pose, time, footprint, movers));
}

MotionGap gap_along(const std::vector<TrajectoryPoint>& trajectory, double horizon, double step,
                    double asked_gap, const PlanningProblem& problem) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  MotionGap result{kNever, kNever, kNever};
  const auto test = [&](const Pose2& pose, double time) {
    const double mover_gap = gap_to_movers(pose, time, problem.footprint, problem.movers);
    const double gap = std::min(mover_gap, gap_to_statics(pose, problem.footprint, problem.obstacles));
    result.mover_gap = std::min(result.mover_gap, mover_gap);
    result.gap = std::min(result.gap, gap);
    if (gap < asked_gap) result.contact_time = std::min(result.contact_time, time);
  };
  for (std::size_t i = 0; i + 1 < trajectory.size() && trajectory[i].time < horizon; ++i) {
    const TrajectoryPoint& a = trajectory[i];
    const TrajectoryPoint& b = trajectory[i + 1];
    const double travel = (b.pose.position() - a.pose.position()).norm();
    const double tests = std::ceil(std::max(travel / step, (b.time - a.time) / kTimeStep));
    const int samples = static_cast<int>(std::clamp(tests, 1.0, kMostTestsPerSegment));
    const double turn = wrap_angle(b.pose.theta - a.pose.theta);
    for (int k = 0; k < samples; ++k) {
      const double s = static_cast<double>(k) / samples;
      const double time = a.time + s * (b.time - a.time);
      if (time > horizon) break;
      test({a.pose.x + s * (b.pose.x - a.pose.x), a.pose.y + s * (b.pose.y - a.pose.y),
            a.pose.theta + s * turn},
           time);
    }
  }
  if (!trajectory.empty() && trajectory.back().time <= horizon)
    test(trajectory.back().pose, trajectory.back().time);
  return result;
}

}  // namespace bw
