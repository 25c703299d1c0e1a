// Opens a serial line for this process alone. May take long (a hung USB adapter, a look through all
// processes): not for a lane.
#pragma once

#include <string>

#include "runtime/serial/port_options.hpp"
#include "runtime/serial/system_folders.hpp"

namespace bw {

struct OpenedLine {
  int descriptor = -1;  ///< who gets it closes it
  std::string device;   ///< "/dev/ttyUSB0", "usb:A6008isP (/dev/ttyUSB0)"
  std::string fault;    ///< what is wrong and what to do; empty: it is open
};

/// Raw, exclusive, not waiting for a carrier, of low latency. A second process of ours, or a stranger who
/// came first, is named.
OpenedLine open_line(const PortOptions& options, const SystemFolders& folders = {});

/// Why this user may not open `device`, and what to type. Empty: he may, or there is none.
std::string why_not_permitted(const std::string& device);

}  // namespace bw
