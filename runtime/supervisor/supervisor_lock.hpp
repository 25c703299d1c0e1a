// One supervisor for each graph: a lock that the kernel lets go of however its holder ends.
#pragma once

#include <filesystem>

namespace bw {

class SupervisorLock {
 public:
  /// Beside the socket. Throws std::runtime_error that names the holder where there is one.
  explicit SupervisorLock(const std::filesystem::path& socket);
  ~SupervisorLock();
  SupervisorLock(const SupervisorLock&) = delete;
  SupervisorLock& operator=(const SupervisorLock&) = delete;

  [[nodiscard]] const std::filesystem::path& socket() const { return socket_; }
  /// Returns when nobody holds it.
  static void wait_until_free(const std::filesystem::path& socket);

 private:
  std::filesystem::path socket_;
  int file_ = -1;
};

}  // namespace bw
