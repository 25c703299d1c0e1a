// The serial lines that this machine has now, and which of them is the adapter with a USB serial number.
// Source: sysfs (class/tty, of USB devices the files `serial` and `product` of an ancestor) and
// /dev/serial/by-id.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/serial/system_folders.hpp"

namespace bw {

struct SerialDevice {
  std::filesystem::path device;      ///< /dev/ttyUSB0
  std::filesystem::path by_id;       ///< /dev/serial/by-id/...: the name that stays; empty: it has none
  std::string driver;                ///< of the kernel: ftdi_sio, cdc_acm
  std::string product;               ///< as the USB device calls itself; empty: not on USB
  std::string usb_serial;            ///< empty: not on USB, or it has none
  std::optional<int> latency_timer;  ///< [ms] that an FTDI adapter holds bytes back
};

/// Sorted by device. Lines that are only reserved (ttyS ports without a chip) are left out.
std::vector<SerialDevice> serial_devices(const SystemFolders& folders = {});

struct FoundPort {
  std::filesystem::path device;
  std::string fault;  ///< what to do where there is none, or more than one; empty: found
};

/// Of `port` as robot files name it: a path, or usb:SERIAL.
FoundPort find_port(const std::string& port, const SystemFolders& folders = {});

}  // namespace bw
