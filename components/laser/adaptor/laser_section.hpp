// Section `laser` of the robot file, all of it. For the adaptor only.
#pragma once

#include <optional>
#include <string>

#include "components/laser/rplidar/rplidar.hpp"
#include "components/laser/scan.hpp"
#include "components/model/robot.hpp"
#include "runtime/component.hpp"
#include "runtime/serial/port_options.hpp"

namespace bw::laser {

struct LaserSection {
  std::string driver;
  PortOptions cable;
  std::string frame = "laser";
  RplidarOptions rplidar;
  ScanOptions scan;

  template <class Visitor>
  void fields(Visitor& v) {
    v("driver", driver, {.doc = "what speaks to the laser"});
    cable.fields(v);
    v("frame", frame, {.doc = "of the robot's sensors: where it sits; x points to its 0 degrees"});
    rplidar.fields(v);
    scan.fields(v);
  }
  std::optional<std::string> violated_rule() const { return scan.violated_rule(); }
};

/// Throws ConfigError for a driver that there is not, without a port, and for a frame that is none of the
/// robot's sensors.
LaserSection read_laser_section(Setup& setup, const Robot& robot);

}  // namespace bw::laser
