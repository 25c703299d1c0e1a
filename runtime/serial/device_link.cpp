#include "runtime/serial/device_link.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "runtime/dds/participant.hpp"
#include "runtime/serial/emulator_path.hpp"
#include "runtime/serial/guarded_port.hpp"
#include "runtime/serial/pseudo_terminal.hpp"
#include "runtime/serial/serial_port.hpp"
#include "runtime/serial/topic_link.hpp"

namespace bw {
namespace {

/// An emulator in a process of its own starts beside its host.
constexpr Duration kEmulatorStarts = Duration::milliseconds(5000);

std::string topic(const std::string& name, const char* direction) { return "sim/" + name + "/" + direction; }

std::string path_of(const Setup& setup, const std::string& name) {
  std::string of_robot = setup.frame(name);  // among several by its prefix: "robot1/base"
  std::ranges::replace(of_robot, '/', '-');
  return emulator_path(of_robot, setup.network().domain_id).string();
}

std::unique_ptr<SerialPort> emulated_port(const Setup& setup, const std::string& name, PortOptions options) {
  options.port = path_of(setup, name);
  return std::make_unique<SerialPort>(options, "the emulator of the " + name, kEmulatorStarts);
}

}  // namespace

std::unique_ptr<ByteLink> device_link(Setup& setup, const std::string& name, const PortOptions& options,
                                      std::vector<std::uint8_t> stop_frame) {
  const bool is_emulated = options.port == kEmulatorPort;
  if (setup.is_lockstep() && !is_emulated)
    throw std::runtime_error("the " + name + " is a real device (port: " + options.port +
                             "): it cannot be driven in lock-step, only in real time");
  if (setup.is_lockstep())
    return std::make_unique<TopicLink>(setup, topic(name, "from_device"), topic(name, "to_device"));
  auto port = is_emulated ? emulated_port(setup, name, options) : std::make_unique<SerialPort>(options);
  if (stop_frame.empty()) return port;
  return std::make_unique<GuardedPort>(std::move(port), std::move(stop_frame));
}

std::unique_ptr<ByteLink> emulator_link(Setup& setup, const std::string& name) {
  if (setup.is_lockstep())
    return std::make_unique<TopicLink>(setup, topic(name, "to_device"), topic(name, "from_device"));
  return std::make_unique<PseudoTerminal>(path_of(setup, name));
}

}  // namespace bw
