// An emulated cable and both of its ends, in real time.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/serial/pseudo_terminal.hpp"
#include "runtime/serial/serial_port.hpp"
#include "tests/folder.hpp"
#include "tests/interop/eventually.hpp"

namespace bw::test {

/// Of a clock that only goes forward.
inline Time now() {
  return {std::chrono::duration_cast<std::chrono::nanoseconds>(
              std::chrono::steady_clock::now().time_since_epoch())
              .count()};
}

inline std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

/// Updates until it is open.
inline bool opens(ByteLink& link) {
  return eventually([&] { return link.update(now()).is_open; });
}
inline bool closes(ByteLink& link) {
  return eventually([&] { return !link.update(now()).is_open; });
}
/// Updates until it says a fault that contains `words`.
inline bool says(ByteLink& link, const std::string& words) {
  return eventually([&] { return link.update(now()).fault.find(words) != std::string::npos; });
}
/// Reads until `count` bytes came, or for as long as eventually() waits.
inline std::string reads(ByteLink& link, std::size_t count) {
  std::string text;
  static_cast<void>(eventually([&] {
    const auto bytes = link.read();
    text.append(bytes.begin(), bytes.end());
    return text.size() >= count;
  }));
  return text;
}

struct Cable {
  Folder folder;
  PseudoTerminal device{folder / "cable"};
  SerialPort host{{.port = (folder / "cable").string(), .baud = 115'200}};

  bool connects() { return device.update(now()).is_open && opens(host); }
};

}  // namespace bw::test
