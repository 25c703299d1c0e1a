#include "components/lab/bench/buildings/bases.hpp"

namespace bw::buildings {

const char* to_text(DrivenBase base) {
  switch (base) {
    case DrivenBase::kobuki:
      return "kobuki";
    case DrivenBase::qbot2e:
      return "qbot2e";
    case DrivenBase::eddie:
      return "eddie";
  }
  return "unknown";
}

Robot robot_of(DrivenBase base) {
  Robot robot;
  if (base == DrivenBase::eddie) {
    robot.name = "Eddie";
    robot.wheel_radius = 0.0762;
    robot.wheel_separation = 0.39;
    robot.ticks_per_revolution = 144;
    robot.wheel_speed_max = 1.0;
    robot.radius = 0.225;
    robot.limits.acc_max = 0.8;
    return robot;
  }
  robot.name = base == DrivenBase::kobuki ? "Kobuki" : "QBot 2e";
  robot.wheel_radius = 0.035;
  robot.wheel_separation = base == DrivenBase::kobuki ? 0.230 : 0.235;
  robot.ticks_per_revolution = 2578;
  robot.wheel_speed_max = 0.7;
  robot.radius = 0.18;
  robot.limits.acc_max = 1.0;
  return robot;
}

DriveOptions perfect_wheels_of(DrivenBase base) {
  DriveOptions wheels;
  wheels.wheel_acceleration = robot_of(base).limits.acc_max;
  return wheels;
}

DriveOptions wheels_of(DrivenBase base) {
  DriveOptions wheels = perfect_wheels_of(base);
  wheels.mismatch = 0.004;
  wheels.noise = 3e-5;
  if (base == DrivenBase::qbot2e) wheels.separation_error = 0.230 / 0.235 - 1.0;
  return wheels;
}

DriveOptions calibrated_wheels_of(DrivenBase base) {
  DriveOptions wheels = wheels_of(base);
  wheels.mismatch = 0.001;
  wheels.separation_error = 0.003;
  wheels.scale = 0.002;
  return wheels;
}

}  // namespace bw::buildings
