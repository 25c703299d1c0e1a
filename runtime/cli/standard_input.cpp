#include "runtime/cli/standard_input.hpp"

#include <algorithm>
#include <array>
#include <cerrno>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bw::cli {

namespace {

// Opened once more, so that not to block is ours and not that of the shell that shares it. A file keeps its
// place and blocks nobody; what cannot be opened (a socket, a terminal of somebody else's) is read as it is.
int reopened() {
  struct stat status {};
  if (fstat(STDIN_FILENO, &status) != 0 || S_ISREG(status.st_mode)) return STDIN_FILENO;
  const int descriptor = open("/proc/self/fd/0", O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  return descriptor < 0 ? STDIN_FILENO : descriptor;
}

}  // namespace

StandardInput::StandardInput() : descriptor_(reopened()) {}

StandardInput::~StandardInput() {
  if (descriptor_ != STDIN_FILENO) close(descriptor_);
}

std::optional<std::string> StandardInput::wait(Duration limit) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t ns = std::max<std::int64_t>(limit.nanoseconds, 0);
  const timespec timeout{.tv_sec = ns / kSecond, .tv_nsec = ns % kSecond};
  pollfd input{.fd = is_over_ ? -1 : descriptor_, .events = POLLIN, .revents = 0};
  if (ppoll(&input, 1, &timeout, nullptr) <= 0) return std::nullopt;
  return take();
}

std::optional<std::string> StandardInput::take() {
  std::array<char, 256> block{};
  const ssize_t size = is_over_ ? 0 : read(descriptor_, block.data(), block.size());
  if (size > 0) return std::string(block.data(), static_cast<std::size_t>(size));
  is_over_ = size == 0 || (errno != EAGAIN && errno != EINTR);
  return std::nullopt;
}

}  // namespace bw::cli
