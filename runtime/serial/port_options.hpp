// Where a device is plugged in, as a robot file says it.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/base/field.hpp"

namespace bw {

struct PortOptions {
  std::string port;  ///< /dev/kobuki, usb:SERIAL_NUMBER, or `emulator`
  std::int64_t baud = 115200;

  template <class Visitor>
  void fields(Visitor& v) {
    v("port", port,
      {.doc =
           "device path, usb:SERIAL for the adapter with that USB serial number wherever it is plugged in, or emulator"});
    v("baud", baud, {.unit = "bit/s", .min = 1200, .max = 4'000'000, .doc = "speed of the line, 8N1"});
  }
};

/// The word that stands for an emulated device instead of a path.
inline constexpr const char* kEmulatorPort = "emulator";

}  // namespace bw
