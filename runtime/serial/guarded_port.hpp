// The serial port of a base that must not drive on when this process cannot stop it: a SerialPort with a
// guardian. What a guardian does, what becomes of it and of this process: components/robot_base/README.md.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/byte_link.hpp"
#include "runtime/serial/background_jobs.hpp"
#include "runtime/serial/port_guardian.hpp"
#include "runtime/serial/serial_port.hpp"

namespace bw {

class GuardedPort final : public ByteLink {
 public:
  /// `stop_frame`: the bytes that make the base stand. `guardian`: another program than the one beside this.
  GuardedPort(std::unique_ptr<SerialPort> port, std::vector<std::uint8_t> stop_frame,
              std::string guardian = {});
  /// The guardian says one last stop, and ends.
  ~GuardedPort() override;
  GuardedPort(const GuardedPort&) = delete;
  GuardedPort& operator=(const GuardedPort&) = delete;

  /// Open with a guardian or not at all: without one, and after a hang of this process, the base is told to
  /// stand, the port is closed and opened anew with another.
  const LinkState& update(Time now) override;
  std::span<const std::uint8_t> read() override { return port_->read(); }
  /// Nothing goes out that was meant before a hang.
  bool write(std::span<const std::uint8_t> bytes) override;
  void close(Time now, const std::string& why) override;
  bool set_dtr(bool is_set) override { return port_->set_dtr(is_set); }
  void rest() override;

 private:
  void begin(Time now, const LinkState& port);
  void give_up(Time now, const std::string& why);
  void let_go();

  std::unique_ptr<SerialPort> port_;
  std::vector<std::uint8_t> stop_frame_;
  std::string program_;
  std::shared_ptr<PortGuardian> guardian_;  ///< null: the port is not open
  BackgroundJobs jobs_;                     ///< the end of a guardian takes a moment
};

}  // namespace bw
