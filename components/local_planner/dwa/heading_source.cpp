#include "components/local_planner/dwa/heading_source.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bw::dwa {
namespace {

double bearing(const Vector2& vector) { return std::atan2(vector.y(), vector.x()); }

/// Error of `heading_of(end of the sample)` against the bearing of the aim from there.
template <class HeadingOf>
std::function<double(const Sample&)> error_to(const Vector2& aim, double goal_tolerance,
                                              HeadingOf heading_of) {
  return [=](const Sample& sample) {
    const Pose2 end = sample.arc.at(sample.horizon);
    const Vector2 left_to_go = aim - end.position();
    const double share = std::min(1.0, left_to_go.norm() / goal_tolerance);
    return share * wrap_angle(bearing(left_to_go) - heading_of(end));
  };
}

double speed_of(const Sample& sample) { return std::abs(sample.arc.twist.v); }

}  // namespace

HeadingSource towards_aim(const DrivingOptions& driving) {
  return [=](const PlanningProblem& problem, const Vector2& aim) {
    return Guidance{
        error_to(aim, arrival_tolerance(problem, driving).xy, [](const Pose2& end) { return end.theta; }),
        speed_of,
        {}};
  };
}

HeadingSource towards_hrvo(const EdwaOptions& options, const hrvo::HrvoOptions& hrvo,
                           const DrivingOptions& driving) {
  return [=, as_dwa = towards_aim(driving)](const PlanningProblem& problem, const Vector2& aim) {
    Guidance guidance = as_dwa(problem, aim);
    hrvo::Advice advice = hrvo::advise(problem, aim, hrvo);
    const double speed = advice.velocity.norm();
    const double theta_hrvo = bearing(advice.velocity);
    const bool has_direction = speed >= hrvo::kNoDirection;
    if (has_direction && options.heading == EdwaHeading::hrvo) {
      guidance.heading_error = [=, theta = problem.pose.theta](const Sample& sample) {
        const double time = std::min(kHeadingTime, sample.horizon);
        return wrap_angle(theta_hrvo - (theta + sample.arc.twist.omega * time));
      };
    } else if (has_direction && options.heading == EdwaHeading::hrvo_printed) {
      guidance.heading_error =
          error_to(aim, arrival_tolerance(problem, driving).xy, [=](const Pose2&) { return theta_hrvo; });
    }
    if (options.hrvo_speed) {
      guidance.velocity_score = [=, v_max = problem.limits.v_max](const Sample& sample) {
        return v_max - std::abs(sample.arc.twist.v - speed);
      };
    }
    guidance.advice = std::move(advice);
    return guidance;
  };
}

}  // namespace bw::dwa
