#include "components/laser/adaptor/laser_section.hpp"

#include <utility>

#include "runtime/parameters/config_error.hpp"
#include "runtime/parameters/nearest.hpp"

namespace bw::laser {
namespace {

[[noreturn]] void refuse(const std::string& key, const std::string& value, std::string rule) {
  Violation violation;
  violation.key = "robot.laser." + key;
  violation.value = value;
  violation.rule = std::move(rule);
  throw ConfigError(violation);
}

}  // namespace

LaserSection read_laser_section(Setup& setup, const Robot& robot) {
  LaserSection section;
  section.driver = robot.laser.driver;
  if (section.driver != "rplidar")
    refuse("driver", section.driver, unknown_rule("driver", section.driver, {"none", "rplidar"}));
  section = setup.shared<LaserSection>("robot.laser", section);
  if (section.cable.port.empty()) refuse("port", "", "must be a device path, usb:SERIAL or emulator");
  if (!robot.has_mount_of(section.frame))
    refuse("frame", section.frame, "robot.sensors must say where a sensor with this frame sits");
  return section;
}

}  // namespace bw::laser
