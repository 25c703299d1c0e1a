// A calibration between a person and a robot: every leg is asked for, and driven alone; Ctrl-C, the end of
// the input or any line typed while it drives stops the robot and ends it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "components/program/calibrate/lines.hpp"
#include "components/program/calibrate/robot_front.hpp"
#include "components/robot_base/calibration/leg_driver.hpp"

namespace bw {

/// Why a calibration ended before its end.
class CalibrationAborted : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

class CalibrationSession {
 public:
  CalibrationSession(RobotFront& robot, const LegOptions& legs) : robot_(robot), legs_(legs) {}

  /// Until the robot can be driven; throws CalibrationAborted with what keeps it after 10 s.
  void wait_for_robot();
  /// The answer; the robot stands meanwhile.
  std::string ask(const std::string& question);
  /// "yes" for Enter; q ends.
  void confirm(const std::string& what);
  std::vector<WheelRotations> drive(const Leg& leg);
  /// Of the localization, once the robot has stood for 1 s.
  Pose2 pose_on_map();

 private:
  void step(const Twist2& twist);
  [[noreturn]] void end(const std::string& why);

  RobotFront& robot_;
  LegOptions legs_;
  Lines lines_;
};

}  // namespace bw
