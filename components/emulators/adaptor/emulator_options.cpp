#include "components/emulators/adaptor/emulator_options.hpp"

#include <utility>
#include <vector>

#include "runtime/parameters/config_error.hpp"

namespace bw {

std::unique_ptr<emulators::EmulatedBase> make_firmware(const BaseEmulatorOptions& options, const Robot& robot,
                                                       const std::string& driver, std::uint64_t seed) {
  if (driver == "kobuki") return std::make_unique<emulators::KobukiFirmware>(options.kobuki, robot, seed);
  if (driver == "eddie") return std::make_unique<emulators::EddieFirmware>(options.eddie, robot);
  Violation unknown;
  unknown.key = "robot.base.driver";
  unknown.value = driver;
  unknown.rule = "has no emulator: kobuki and eddie have one";
  throw ConfigError(unknown);
}

}  // namespace bw
