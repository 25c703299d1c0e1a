// What a process tells the service manager that started it (systemd, or whoever else gives NOTIFY_SOCKET):
// sd_notify's protocol, a datagram of lines NAME=VALUE on a Unix socket.
#pragma once

#include <string>
#include <string_view>

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
  void stopping(std::string_view status) const { send("STOPPING=1", status); }
  /// One line for `systemctl status`.
  void status(std::string_view status) const { send({}, status); }

 private:
  /// Without waiting: a manager that does not read loses it. A status that has several lines is told up to the
  /// first end of line.
  void send(std::string_view state, std::string_view status) const;

  std::string address_;
  int socket_ = -1;
};

}  // namespace bw
