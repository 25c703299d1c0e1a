// A simulated world never moves a real robot. For the adaptor only.
#pragma once

#include "components/model/robot.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Throws ConfigError, at the section `base` of the robot, when its driver would speak to a real device.
void refuse_hardware(Setup& setup, const Robot& robot);

}  // namespace bw
