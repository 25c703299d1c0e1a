#include "runtime/cli/doctor_devices.hpp"

#include <optional>

#include <fmt/format.h>
#include <sys/stat.h>

#include "runtime/parameters/read_parameters.hpp"
#include "runtime/serial/open_line.hpp"
#include "runtime/serial/port_holders.hpp"
#include "runtime/serial/serial_devices.hpp"
#include "runtime/serial/tty_settings.hpp"

namespace bw::cli {
namespace {

std::string description(const SerialDevice& device) {
  std::string text = device.device.string();
  if (!device.product.empty()) text += fmt::format(", {}", device.product);
  if (!device.driver.empty()) text += fmt::format(", driver {}", device.driver);
  if (!device.usb_serial.empty()) text += fmt::format(", port: usb:{}", device.usb_serial);
  if (!device.by_id.empty()) text += fmt::format(", {}", device.by_id.string());
  return text;
}

void check_latency(DoctorReport& report, const SerialDevice& device) {
  constexpr int kShort = 4;  // [ms]: bases send every 20 ms
  if (!device.latency_timer || *device.latency_timer <= kShort) return;
  report.warn(
      fmt::format("{} holds bytes back for {} ms; a driver of this program asks for less when it opens it, "
                  "config/udev/99-bandwagon.rules sets 1 ms for good",
                  device.device.string(), *device.latency_timer));
}

void check_device(DoctorReport& report, const SerialDevice& device, const SystemFolders& folders) {
  const std::string name = device.device.string();
  if (const std::string why = why_not_permitted(name); !why.empty()) {
    report.warn(description(device) + ": " + why);
    return;
  }
  struct stat status {};
  const bool is_there = stat(name.c_str(), &status) == 0;
  const auto holders = is_there ? holders_of(status, -1, folders) : std::vector<PortHolder>{};
  if (!is_there) {
    report.warn(description(device) + ": the kernel knows it, but there is no such file (udev?)");
  } else if (!holders.empty()) {
    report.warn(description(device) + ": in use by " + in_words(holders));
  } else {
    report.ok(description(device) + ": you may open it, and nobody seen has it open");
  }
  check_latency(report, device);
}

std::optional<GraphPort> port_of(const ConfigEntry& section, const std::string& path, const Graph& graph) {
  const ConfigNode* port = section.value.find("port");
  if (port == nullptr || !port->is_scalar() || port->scalar == kEmulatorPort) return {};
  const ConfigNode* driver = section.value.find("driver");
  if (driver != nullptr && (driver->scalar == "none" || driver->scalar == "simulated")) return {};
  const ComponentNode* component = graph.find(section.key);
  if (component != nullptr && !component->enabled) return {};
  GraphPort found{.section = path, .options = {.port = port->scalar}};
  if (const ConfigNode* baud = section.value.find("baud"); baud != nullptr) {
    // The whole section is the driver's to read; of it only these two keys are everybody's.
    ConfigNode both{.kind = ConfigNode::Kind::kMap, .where = section.where};
    both.map = {{"port", section.where, *port}, {"baud", section.where, *baud}};
    read_into(found.options, both, path);
  }
  return found;
}

}  // namespace

void check_serial_devices(DoctorReport& report, const SystemFolders& folders) {
  const std::vector<SerialDevice> devices = serial_devices(folders);
  if (devices.empty()) report.ok("no serial device is plugged in");
  for (const SerialDevice& device : devices) check_device(report, device, folders);
}

std::vector<GraphPort> ports_of(const Graph& graph) {
  std::vector<GraphPort> ports;
  for (const auto& [name, section] : graph.shared) {
    for (const ConfigEntry& entry : section.map) {
      if (const auto port = port_of(entry, name + "." + entry.key, graph)) ports.push_back(*port);
    }
  }
  return ports;
}

void check_ports(DoctorReport& report, const std::vector<GraphPort>& ports, const SystemFolders& folders) {
  for (const auto& [section, options] : ports) {
    const OpenedLine line = open_line(options, folders);
    const std::string what = fmt::format("{}: {} at {} bit/s", section, line.device, options.baud);
    if (line.fault.empty()) {
      report.ok(what + " can be opened");
      drain_and_close(line.descriptor);
    } else {
      report.fail(what + ": " + line.fault);
    }
  }
}

}  // namespace bw::cli
