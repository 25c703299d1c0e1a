#include "runtime/supervisor/supervisor_lock.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace bw {
namespace {

int open_lock(const std::filesystem::path& socket) {
  const std::filesystem::path path = socket.string() + ".lock";
  const int file = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  if (file < 0) throw std::runtime_error(path.string() + ": " + std::strerror(errno));
  return file;
}

}  // namespace

SupervisorLock::SupervisorLock(const std::filesystem::path& socket)
    : socket_(socket), file_(open_lock(socket)) {
  if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
    std::array<char, 32> holder{};
    static_cast<void>(pread(file_, holder.data(), holder.size() - 1, 0));
    close(file_);
    throw std::runtime_error(std::string("it is launched already, by process ") + holder.data() +
                             "; `bandwagon launch status GRAPH` shows it, `launch stop GRAPH` ends it");
  }
  const std::string id = std::to_string(getpid());
  static_cast<void>(ftruncate(file_, 0));
  static_cast<void>(pwrite(file_, id.data(), id.size(), 0));
}

SupervisorLock::~SupervisorLock() { close(file_); }

void SupervisorLock::wait_until_free(const std::filesystem::path& socket) {
  const int file = open_lock(socket);
  while (flock(file, LOCK_SH) != 0 && errno == EINTR) {
  }
  close(file);
}

}  // namespace bw
