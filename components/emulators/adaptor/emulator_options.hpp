// Parameters of the emulated base, and the firmware that the robot's driver speaks to. For the adaptor only.
#pragma once

#include <memory>
#include <string>

#include "components/emulators/eddie/eddie_firmware.hpp"
#include "components/emulators/faults.hpp"
#include "components/emulators/kobuki/kobuki_firmware.hpp"

namespace bw {

struct BaseEmulatorOptions {
  emulators::KobukiOptions kobuki;
  emulators::EddieOptions eddie;
  double bumper_gap = 0.01;
  emulators::Faults faults;

  template <class Visitor>
  void fields(Visitor& v) {
    v("kobuki", kobuki, {.doc = "a Kobuki's firmware, where robot.base.driver is kobuki"});
    v("eddie", eddie, {.doc = "an Eddie's, where it is eddie"});
    v("bumper_gap", bumper_gap,
      {.unit = "m", .min = 0, .max = 0.1, .doc = "what comes this near to the rim presses a bumper"});
    v("faults", faults, {.doc = "what is wrong with it"});
  }
};

/// Throws ConfigError for a driver that speaks to no emulated base.
std::unique_ptr<emulators::EmulatedBase> make_firmware(const BaseEmulatorOptions& options, const Robot& robot,
                                                       const std::string& driver, std::uint64_t seed);

}  // namespace bw
