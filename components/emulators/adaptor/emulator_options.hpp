// Parameters of the emulated base, and the firmware that the robot's driver speaks to. For the adaptor only.
#pragma once

#include <memory>
#include <string>

#include "components/emulators/eddie/eddie_firmware.hpp"
#include "components/emulators/faults.hpp"
#include "components/emulators/kobuki/kobuki_firmware.hpp"

namespace bw {

struct BaseEmulatorOptions {
  emulators::KobukiOptions kobuki;  ///< a Kobuki's firmware, where robot.base.driver is kobuki
  emulators::EddieOptions eddie;
  /// [m] what comes this near to the rim presses a bumper: the wall that stops the body touches it
  static constexpr double kBumperGap = 0.01;
  emulators::Faults faults;

  template <class Visitor>
  void fields(Visitor& v) {
    v("eddie", eddie, {.doc = "an Eddie's firmware, where robot.base.driver is eddie"});
    v("faults", faults, {.doc = "what is wrong with it"});
    v.retired({"kobuki", "bumper_gap"}, "a constant of kobuki_options.hpp, emulator_options.hpp");
  }
};

/// Throws ConfigError for a driver that speaks to no emulated base.
std::unique_ptr<emulators::EmulatedBase> make_firmware(const BaseEmulatorOptions& options, const Robot& robot,
                                                       const std::string& driver, std::uint64_t seed);

}  // namespace bw
