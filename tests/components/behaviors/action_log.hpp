// A goal as its client hears of it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "components/messages/nav2_results.hpp"
#include "runtime/component.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {

struct Attempt {
  int acknowledged = 0, ends = 0;
  bool accepted = false;
  GoalStatus status = GoalStatus::unknown;
  std::uint16_t code = 0;
  std::string text;
  double elapsed = 0.0, ended_at = 0.0;  ///< [s]
  std::vector<double> feedback;          ///< [m], [rad]; of a wait [s]
};

template <class Feedback>
double value_of(const Feedback& feedback) {
  if constexpr (requires { feedback.angular_distance_traveled(); }) {
    return feedback.angular_distance_traveled();
  } else if constexpr (requires { feedback.distance_traveled(); }) {
    return feedback.distance_traveled();
  } else {
    return feedback.time_left().sec() + 1e-9 * feedback.time_left().nanosec();
  }
}

/// `attempt` must outlive the run.
template <class A>
GoalId send_goal(const ActionClient<A>& client, const typename A::Goal& goal, Attempt& attempt) {
  return client.send(goal, Duration::milliseconds(100),
                     {.on_acknowledged =
                          [&attempt](bool accepted, const Tick&) {
                            ++attempt.acknowledged;
                            attempt.accepted = accepted;
                          },
                      .on_feedback = [&attempt](const typename A::Feedback& f,
                                                const Tick&) { attempt.feedback.push_back(value_of(f)); },
                      .on_result =
                          [&attempt](GoalStatus status, const typename A::Result* result, const Tick& tick) {
                            ++attempt.ends;
                            attempt.status = status;
                            attempt.ended_at = seconds_since_start(tick.now);
                            if (result == nullptr) return;
                            attempt.code = error_code_of(*result);
                            attempt.text = error_text_of(*result);
                            attempt.elapsed = result->total_elapsed_time().sec() +
                                              1e-9 * result->total_elapsed_time().nanosec();
                          }});
}

template <class Spin>
typename Spin::Goal spin_goal(double yaw, double allowance = 0.0) {
  typename Spin::Goal goal;
  goal.target_yaw(static_cast<float>(yaw));
  goal.time_allowance().sec(static_cast<std::int32_t>(allowance));
  return goal;
}

/// For BackUp and DriveOnHeading.
template <class Drive>
typename Drive::Goal drive_goal(double x, double speed, double allowance = 0.0) {
  typename Drive::Goal goal;
  goal.target().x(x);
  goal.speed(static_cast<float>(speed));
  goal.time_allowance().sec(static_cast<std::int32_t>(allowance));
  return goal;
}

template <class Wait>
typename Wait::Goal wait_goal(double seconds) {
  typename Wait::Goal goal;
  goal.time(to_message(Duration::seconds(seconds)));
  return goal;
}

}  // namespace bw
