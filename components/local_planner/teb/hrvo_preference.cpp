#include "components/local_planner/teb/hrvo_preference.hpp"

#include <cmath>
#include <limits>

#include "components/model/mover_weight.hpp"

namespace bw::teb {
namespace {

constexpr double kLookAhead = 4.0;        // [m] in which the first obstacle is looked for
constexpr double kNear = 1.0;             // [m] clearance below which it counts as passed
constexpr double kWithoutObstacle = 2.0;  // [m] ahead, when none is

double clearance_at(const ObstacleField& field, const TrajectoryPoint& point) {
  double nearest = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Capsule& capsule) {
    nearest = std::min(nearest, gap_to(field.footprint, point.pose, capsule, nearest));
  };
  field.statics.visit_near(point.pose.position(), kNear + field.footprint.radius,
                           [&](const CapsuleIndex::Group& group) {
                             for (const std::uint32_t i : field.statics.members(group))
                               look_at(field.statics.capsules()[i]);
                           });
  for (const Mover& m : field.movers) {
    if (!is_confirmed(m)) continue;
    const Vector2 p = m.position_at(point.time);
    look_at({p, p, m.radius});
  }
  return nearest;
}

// zeta_p.
Vector2 first_passing_point(const std::vector<TrajectoryPoint>& trajectory, const ObstacleField& field) {
  double nearest = kNear;
  double travelled = 0.0;
  bool found = false;
  Vector2 point = trajectory.back().pose.position();
  bool beyond = false;
  for (std::size_t i = 1; i < trajectory.size() && travelled < kLookAhead; ++i) {
    travelled += (trajectory[i].pose.position() - trajectory[i - 1].pose.position()).norm();
    const double clearance = clearance_at(field, trajectory[i]);
    if (clearance < nearest) {
      nearest = clearance;
      point = trajectory[i].pose.position();
      found = true;
    } else if (!found && !beyond && travelled >= kWithoutObstacle) {
      beyond = true;
      point = trajectory[i].pose.position();
    }
  }
  return point;
}

}  // namespace

double hrvo_cost(const hrvo::Advice& advice, const std::vector<TrajectoryPoint>& trajectory,
                 const ObstacleField& field, double weight) {
  if (advice.velocity.norm() < hrvo::kNoDirection || trajectory.size() < 2) return 0.0;
  const Vector2 to_passing = first_passing_point(trajectory, field) - trajectory.front().pose.position();
  if (to_passing.norm() < 1e-6) return 0.0;
  return weight * std::abs(std::atan2(cross(advice.velocity, to_passing), advice.velocity.dot(to_passing)));
}

ChoiceTermSource hrvo_preference(const hrvo::HrvoOptions& hrvo, double weight) {
  return [=](const PlanningProblem& problem, const ObstacleField& field) {
    const hrvo::Advice advice = hrvo::advise(problem, problem.plan.back().position(), hrvo);
    return ChoiceTerm{.cost =
                          [=, &field](const BandCandidate& candidate) {
                            return hrvo_cost(advice, candidate.trajectory, field, weight);
                          },
                      .advice = advice};
  };
}

}  // namespace bw::teb
