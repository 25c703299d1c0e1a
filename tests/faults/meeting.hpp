// A guarded drive at 1 m/s that meets somebody, and what came of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "tests/faults/guarded_drive.hpp"

namespace bw {

inline constexpr double kPerson = 0.3;  // radius [m]
inline constexpr double kRobot = 0.3;   // radius [m]

struct Meeting {
  std::optional<double> contact_speed;  ///< [m/s], of the robot
  double least_gap = 10.0;              ///< [m]
};

/// Runs `drive` straight on.
inline Meeting watch(GuardedDrive& drive, double seconds) {
  Meeting meeting;
  double before = 0.0;
  drive.wish = [](double) { return Twist2{1.0, 0.0}; };
  drive.see = [&](double, const bandwagon_msgs::msg::GroundTruth& truth) {
    const double v = truth.twist().linear().x();
    const auto& robot = truth.pose().position();
    for (const auto& person : truth.people()) {
      const double gap = std::hypot(person.position().x() - robot.x(), person.position().y() - robot.y()) -
                         (kRobot + kPerson);
      meeting.least_gap = std::min(meeting.least_gap, gap);
      if (gap < 0.0 && !meeting.contact_speed) meeting.contact_speed = std::max(before, v);
    }
    before = v;
  };
  drive.run(seconds);
  return meeting;
}

struct Outcome {
  int contacts = 0;
  double worst = 0.0;  ///< contact speed [m/s]
  double least_gap = 10.0;
};

/// Of `n` meetings.
inline Outcome outcome_of(int n, const std::function<Meeting(int i)>& meet) {
  Outcome outcome;
  for (int i = 0; i < n; ++i) {
    const Meeting meeting = meet(i);
    outcome.contacts += meeting.contact_speed ? 1 : 0;
    outcome.worst = std::max(outcome.worst, meeting.contact_speed.value_or(0.0));
    outcome.least_gap = std::min(outcome.least_gap, meeting.least_gap);
  }
  return outcome;
}

}  // namespace bw
