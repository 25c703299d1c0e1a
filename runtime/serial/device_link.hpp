// The two ends of a device's cable for components. A real device is a serial port. An emulated one is, in
// real time, a pseudo-terminal whose name both ends know; in lock-step, where no byte may depend on a real
// clock, two topics `sim/NAME/to_device` and `sim/NAME/from_device`, so that the bytes are hashed, recorded
// and replayed as all else.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/byte_link.hpp"
#include "runtime/component.hpp"
#include "runtime/serial/port_options.hpp"

namespace bw {

/// The host's end of device `name` ("base", "laser"). Declares topics where the device is emulated in
/// lock-step; opens nothing before its first update(). With a `stop_frame`, the bytes that bring the device
/// to rest, its port has a guardian in real time, which sends them when this process cannot
/// (guarded_port.hpp).
std::unique_ptr<ByteLink> device_link(Setup& setup, const std::string& name, const PortOptions& options,
                                      std::vector<std::uint8_t> stop_frame = {});

/// The device's end, for its emulator.
std::unique_ptr<ByteLink> emulator_link(Setup& setup, const std::string& name);

}  // namespace bw
