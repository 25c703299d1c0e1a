#include "runtime/supervisor/child_stream.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>

namespace bw {

void pass_on(int descriptor, std::string_view text) {
  pollfd ready{.fd = descriptor, .events = POLLOUT, .revents = 0};
  if (poll(&ready, 1, 0) == 1 && (ready.revents & POLLOUT) != 0)
    static_cast<void>(write(descriptor, text.data(), text.size()));
}

Descriptor ChildStream::open() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  pipe_ = Descriptor(ends[0]);
  log_.forget_last_words();
  return Descriptor(ends[1]);
}

void ChildStream::drain() {
  constexpr int kMostAtOnce = 64;
  std::array<char, 4096> text{};  // as much as a pipe takes at once when it takes anything
  for (int i = 0; i < kMostAtOnce; ++i) {
    const ssize_t size = read(pipe_.get(), text.data(), text.size());
    if (size <= 0) return;
    const std::string_view part(text.data(), static_cast<std::size_t>(size));
    log_.write(part);
    pass_on(to_, part);
  }
}

std::string ChildStream::news_of_fault() {
  return log_.fault().empty() || std::exchange(is_fault_told_, true) ? std::string() : log_.fault();
}

}  // namespace bw
