#include "components/local_planner/dwa/rotate_to_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::dwa {
namespace {

constexpr double kSampled = 0.5;   // [m] ahead it is looked where the plan leads: Nav2's rotation shim
constexpr double kAhead = 0.2;     // [rad] at which a rotation ends
constexpr double kTooNear = 0.05;  // [m] from where a point has no bearing
constexpr double kTwoPi = 2.0 * std::numbers::pi;

}  // namespace

std::optional<double> RotateToPlan::angle(const PlanningProblem& problem, const Course& course,
                                          const CriticOptions& options) {
  const double v = std::abs(problem.twist.v);
  const double stopping = v * problem.command_lead + v * v / (2.0 * problem.limits.acc_max);
  const double ahead = std::max(kSampled, stopping);
  const Vector2 to_plan =
      course.line.at(std::min(course.along + ahead, course.line.length())) - problem.pose.position();
  const double bearing =
      to_plan.norm() < kTooNear ? 0.0 : wrap_angle(std::atan2(to_plan.y(), to_plan.x()) - problem.pose.theta);
  if (std::abs(bearing) <= (side_ == 0.0 ? options.kRotateThreshold : kAhead)) {
    side_ = 0.0;
    return std::nullopt;
  }
  if (side_ == 0.0) side_ = std::copysign(1.0, bearing);
  // Behind the robot left and right are equally far.
  const double behind = std::numbers::pi - std::abs(bearing);
  if (side_ * bearing < 0.0 && behind < 1.0) return bearing + side_ * kTwoPi;
  side_ = std::copysign(1.0, bearing);
  return bearing;
}

double rotation_left_over(const Twist2& held, double angle, const PlanningProblem& problem) {
  const double late = std::max(problem.control_period, problem.command_lead);
  const double coming =
      held.omega * late + held.omega * std::abs(held.omega) / (2.0 * problem.limits.alpha_max);
  return std::abs(angle - coming);
}

}  // namespace bw::dwa
