#include "runtime/serial/serial_devices.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

namespace bw {
namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& file) {
  std::string line;
  std::ifstream stream(file);
  std::getline(stream, line);
  return line;
}

/// The USB device above the folder of a line; empty where there is none.
fs::path usb_device_above(fs::path folder, const fs::path& root) {
  std::error_code none;
  for (; folder.has_relative_path() && folder != root; folder = folder.parent_path()) {
    if (fs::exists(folder / "idVendor", none)) return folder;
  }
  return {};
}

fs::path name_by_id(const fs::path& device, const SystemFolders& folders) {
  std::error_code error;
  fs::path found;
  for (const auto& entry : fs::directory_iterator(folders.dev / "serial" / "by-id", error)) {
    std::error_code dangling;
    if (fs::weakly_canonical(entry.path(), dangling) == fs::weakly_canonical(device, dangling) &&
        (found.empty() || entry.path() < found))
      found = entry.path();
  }
  return found;
}

SerialDevice describe(const fs::path& line, const SystemFolders& folders) {
  std::error_code error;
  const fs::path folder = fs::canonical(line / "device", error);
  SerialDevice device{.device = folders.dev / line.filename()};
  device.by_id = name_by_id(device.device, folders);
  device.driver = fs::weakly_canonical(folder / "driver", error).filename().string();
  if (const fs::path usb = usb_device_above(folder, fs::weakly_canonical(folders.sys, error)); !usb.empty()) {
    device.product = first_line(usb / "product");
    device.usb_serial = first_line(usb / "serial");
  }
  if (int milliseconds = 0; std::ifstream(folder / "latency_timer") >> milliseconds)
    device.latency_timer = milliseconds;
  return device;
}

bool is_there(const fs::path& line) {
  std::error_code error;
  if (!fs::exists(line / "device", error)) return false;
  // The kernel reserves ttyS0 to ttyS3 whether or not there is a chip; then their type is 0.
  return !fs::exists(line / "type", error) || first_line(line / "type") != "0";
}

}  // namespace

std::vector<SerialDevice> serial_devices(const SystemFolders& folders) {
  std::vector<SerialDevice> devices;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folders.sys / "class" / "tty", error)) {
    if (is_there(entry.path())) devices.push_back(describe(entry.path(), folders));
  }
  std::ranges::sort(devices, {}, &SerialDevice::device);
  return devices;
}

FoundPort find_port(const std::string& port, const SystemFolders& folders) {
  constexpr std::string_view kUsb = "usb:";
  if (!port.starts_with(kUsb)) return {.device = port, .fault = {}};
  const std::string serial = port.substr(kUsb.size());
  if (serial.empty())
    return {.device = {}, .fault = "no USB adapter is named: usb: is followed by its serial number"};
  std::vector<SerialDevice> devices = serial_devices(folders);
  std::erase_if(devices, [&](const SerialDevice& device) { return device.usb_serial != serial; });
  if (devices.empty())
    return {.device = {},
            .fault = fmt::format("no USB adapter with the serial number {}: plug it in; `bandwagon doctor` "
                                 "lists those there are",
                                 serial)};
  if (devices.size() > 1)
    return {
        .device = {},
        .fault = fmt::format("{} lines have the USB serial number {} ({}, {}): name one by its path",
                             devices.size(), serial, devices[0].device.string(), devices[1].device.string())};
  return {.device = devices.front().device, .fault = {}};
}

}  // namespace bw
