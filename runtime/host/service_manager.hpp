// What a process tells the service manager that started it (systemd, `bandwagon launch`, or whoever else gives
// NOTIFY_SOCKET): sd_notify's protocol, a datagram of lines NAME=VALUE on a Unix socket. Source: man sd_notify(3),
// sd_watchdog_enabled(3).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/time.hpp"

namespace bw {

class ServiceManager {
 public:
  /// Who NOTIFY_SOCKET names: a path, or an abstract socket that begins with @. Nobody is told where it is
  /// empty or unset.
  ServiceManager();
  ~ServiceManager();
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  /// READY=1: everything that is to be up is up.
  void ready(std::string_view status) const { send("READY=1", status); }
  /// STOPPING=1. `is_over`: by its own decision or because it was told to; `bandwagon launch` starts it again else.
  void stopping(std::string_view status, bool is_over) const {
    send(is_over ? "STOPPING=1\nX_BANDWAGON_OVER=1" : "STOPPING=1", status);
  }
  /// EXTEND_TIMEOUT_USEC: its end takes so long from now on; what moves is at rest.
  void takes_time_to_end(Duration time) const {
    send("EXTEND_TIMEOUT_USEC=" + std::to_string(time.nanoseconds / 1000), {});
  }
  /// One line for `systemctl status`.
  void status(std::string_view status) const { send({}, status); }
  /// WATCHDOG=1: it lives.
  void alive() const { send("WATCHDOG=1", {}); }
  /// WATCHDOG=trigger: a part of it does not come back; it is to be ended at once.
  void hangs(std::string_view status) const { send("WATCHDOG=trigger", status); }

  /// Who does not say alive() for so long is ended; zero: nobody looks.
  [[nodiscard]] Duration watchdog() const { return watchdog_; }
  /// How the process ended in whose place this one was started, as `bandwagon launch` tells it; empty: there was none.
  static std::string predecessor();
  /// Somebody starts this process again when it ends.
  static bool is_launched();
  /// How long ago `bandwagon launch` began; nothing: it did not start this process.
  static std::optional<Duration> since_launch();

 private:
  /// Without waiting: a manager that does not read loses it. A status that has several lines is told up to the
  /// first end of line.
  void send(std::string_view state, std::string_view status) const;

  std::string address_;
  int socket_ = -1;
  Duration watchdog_;
};

}  // namespace bw
