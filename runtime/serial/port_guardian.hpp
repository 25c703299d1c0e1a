// The process's side of its port's guardian (guardian_main.cpp), a small process of its own that tells the
// base to stand when this one cannot: killed, aborted or hung. One guardian for each opening of the port.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <sys/types.h>

namespace bw {

/// What `stop_frame` is written to, and by whom.
struct GuardedDevice {
  int descriptor = -1;       ///< of the open port; the guardian gets one of its own
  std::string name;          ///< for people
  std::string program = {};  ///< the guardian; empty: beside this program
};

class PortGuardian {
 public:
  enum class State {
    well,
    gone,     ///< killed, hung, or never there
    tripped,  ///< it has not heard this process in time, and has stopped the device
  };

  /// Starts it; `fault()` tells why it could not.
  PortGuardian(const GuardedDevice& device, std::span<const std::uint8_t> stop_frame);
  /// Gives the port up and waits until the guardian, which says one last stop, has ended: milliseconds, 0.3 s
  /// at most. Not on a lane.
  ~PortGuardian();
  PortGuardian(const PortGuardian&) = delete;
  PortGuardian& operator=(const PortGuardian&) = delete;

  const std::string& fault() const { return fault_; }
  /// What has come from it. Asked before each write to the device: after a hang nothing of before it goes
  /// out.
  State look();
  /// To be called at least every 0.1 s; says so every 20 ms.
  void beat();
  /// No beats will come for a while, and the device stands.
  void rest();

 private:
  void say(char message) const;

  int socket_ = -1;
  pid_t process_ = -1;
  std::string fault_;
  State state_ = State::well;
  int unanswered_ = 0;
  std::int64_t said_ns_ = 0;
};

}  // namespace bw
