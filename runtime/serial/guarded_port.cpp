#include "runtime/serial/guarded_port.hpp"

#include <utility>

namespace bw {

GuardedPort::GuardedPort(std::unique_ptr<SerialPort> port, std::vector<std::uint8_t> stop_frame,
                         std::string guardian)
    : port_(std::move(port)), stop_frame_(std::move(stop_frame)), program_(std::move(guardian)) {}

GuardedPort::~GuardedPort() { let_go(); }

const LinkState& GuardedPort::update(Time now) {
  if (guardian_) {
    const PortGuardian::State state = guardian_->look();
    const std::string device = port_->update(now).device;
    if (state == PortGuardian::State::gone) give_up(now, "the guardian of " + device + " is gone");
    if (state == PortGuardian::State::tripped)
      give_up(now, "this process was silent for 0.2 s: the guardian of " + device + " has stopped the base");
  }
  const LinkState& port = port_->update(now);
  if (!port.is_open) {
    let_go();
  } else if (!guardian_) {
    begin(now, port);
  }
  if (guardian_) guardian_->beat();
  return port;
}

void GuardedPort::begin(Time now, const LinkState& port) {
  guardian_ = std::make_shared<PortGuardian>(
      GuardedDevice{.descriptor = port_->descriptor(), .name = port.device, .program = program_},
      stop_frame_);
  if (!guardian_->fault().empty()) give_up(now, guardian_->fault());
}

bool GuardedPort::write(std::span<const std::uint8_t> bytes) {
  if (!guardian_ || guardian_->look() != PortGuardian::State::well) return false;
  return port_->write(bytes);
}

void GuardedPort::close(Time now, const std::string& why) {
  port_->close(now, why);
  let_go();
}

void GuardedPort::rest() {
  if (guardian_) guardian_->rest();
}

/// Whatever the guardian has said: this process can speak for itself.
void GuardedPort::give_up(Time now, const std::string& why) {
  static_cast<void>(port_->write(stop_frame_));
  close(now, why);
}

void GuardedPort::let_go() {
  if (guardian_) jobs_.add([guardian = std::move(guardian_)]() mutable { guardian.reset(); });
  guardian_.reset();
}

}  // namespace bw
