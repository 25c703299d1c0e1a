#include "components/local_planner/footprint_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "components/model/capsule_index.hpp"
#include "components/model/footprint_distance.hpp"
#include "components/model/mover_weight.hpp"

namespace bw {
namespace {

constexpr double kTimeStep = 0.1;  // [s] between tests of a standing robot: movers come to it
constexpr double kMaxTestsPerSegment = 100.0;
constexpr double kNearBy = 1.0;     // [m] gap from which on an obstacle is not looked at
constexpr double kDistanceRounding = 1e-6;  // [m]

double gap_to_mover(const Pose2& pose, double time, const Footprint& footprint, const Mover& mover,
                    double enough) {
  const Vector2 p = mover.position_at(time);
  return std::min(enough, gap_to(footprint, pose, {p, p, mover.radius}, enough));
}

double gap_to_movers(const Pose2& pose, double time, const Footprint& footprint,
                     const std::vector<Mover>& movers) {
  double gap = std::numeric_limits<double>::infinity();
  for (const Mover& m : movers) {
    if (is_confirmed(m)) gap = gap_to_mover(pose, time, footprint, m, gap);
  }
  return gap;
}

// What a motion over `horizon` seconds can come near to: the rest is looked at once, not at every pose.
class NearMotion {
 public:
  NearMotion(const std::vector<TrajectoryPoint>& trajectory, double horizon, const PlanningProblem& problem)
      : footprint_(problem.footprint) {
    low_ = high_ = trajectory.front().pose.position();
    for (std::size_t i = 1; i < trajectory.size() && trajectory[i - 1].time < horizon; ++i) {
      low_ = low_.cwiseMin(trajectory[i].pose.position());
      high_ = high_.cwiseMax(trajectory[i].pose.position());
    }
    std::vector<Capsule> near;
    for (const Capsule& c : capsules_of(problem.obstacles)) {
      if (is_near(c.a.cwiseMin(c.b), c.a.cwiseMax(c.b), c.radius)) near.push_back(c);
    }
    statics_ = CapsuleIndex(std::move(near));
    for (const Mover& m : problem.movers) {
      const double aside = m.radius + std::max(horizon, 0.0) * m.top_speed();
      if (is_confirmed(m) && is_near(m.position, m.position, aside)) movers_.push_back(&m);
    }
  }

  /// At most `enough`.
  double gap_to_statics(const Pose2& pose, double enough) const {
    double gap = enough;
    statics_.visit_near(pose.position(), std::min(gap, kNearBy) + footprint_.radius + kDistanceRounding,
                        [&](const CapsuleIndex::Group& group) {
                          for (const std::uint32_t i : statics_.members(group))
                            gap = std::min(gap, gap_to(footprint_, pose, statics_.capsules()[i], gap));
                        });
    return gap;
  }

  double gap_to_movers(const Pose2& pose, double time) const {
    double gap = std::numeric_limits<double>::infinity();
    for (const Mover* m : movers_) gap = gap_to_mover(pose, time, footprint_, *m, gap);
    return gap;
  }

 private:
  bool is_near(const Vector2& low, const Vector2& high, double radius) const {
    const double aside = radius + footprint_.radius + kNearBy;
    return (low_ - high).maxCoeff() <= aside && (low - high_).maxCoeff() <= aside;
  }

  const Footprint& footprint_;
  Vector2 low_, high_;  // of the box of its positions
  CapsuleIndex statics_;
  std::vector<const Mover*> movers_;
};

}  // namespace

double gap_to_statics(const Pose2& pose, const Footprint& footprint, const StaticObstacles& statics) {
  double gap = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Capsule& capsule) {
    gap = std::min(gap, gap_to(footprint, pose, capsule, gap));
  };
  for (const Vector2& p : statics.points) look_at({p, p, 0.0});
  for (const Disc& d : statics.discs) look_at({d.center, d.center, d.radius});
  for (const Segment& s : statics.segments) look_at({s.a, s.b, 0.0});
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
  if (trajectory.empty()) return result;
  const NearMotion near(trajectory, horizon, problem);
  const auto test = [&](const Pose2& pose, double time) {
    const double mover_gap = near.gap_to_movers(pose, time);
    const double gap = near.gap_to_statics(pose, std::min(result.gap, mover_gap));
    result.mover_gap = std::min(result.mover_gap, mover_gap);
    result.gap = std::min(result.gap, gap);
    if (gap < asked_gap) result.contact_time = std::min(result.contact_time, time);
  };
  for (std::size_t i = 0; i + 1 < trajectory.size() && trajectory[i].time < horizon; ++i) {
    const TrajectoryPoint& a = trajectory[i];
    const TrajectoryPoint& b = trajectory[i + 1];
    const double travel = (b.pose.position() - a.pose.position()).norm();
    const double tests = std::ceil(std::max(travel / step, (b.time - a.time) / kTimeStep));
    const int samples = static_cast<int>(std::clamp(tests, 1.0, kMaxTestsPerSegment));
    const double rotation = wrap_angle(b.pose.theta - a.pose.theta);
    for (int k = 0; k < samples; ++k) {
      const double s = static_cast<double>(k) / samples;
      const double time = a.time + s * (b.time - a.time);
      if (time > horizon) break;
      test({a.pose.x + s * (b.pose.x - a.pose.x), a.pose.y + s * (b.pose.y - a.pose.y),
            a.pose.theta + s * rotation},
           time);
    }
  }
  if (trajectory.back().time <= horizon) test(trajectory.back().pose, trajectory.back().time);
  return result;
}

}  // namespace bw
