#include "components/tools/calibrate/lines.hpp"

#include <array>

#include <poll.h>
#include <unistd.h>

namespace bw {

std::optional<std::string> Lines::wait(Duration limit) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  if (auto line = next()) return line;
  const timespec timeout{.tv_sec = limit.nanoseconds / kSecond, .tv_nsec = limit.nanoseconds % kSecond};
  pollfd input{.fd = is_over_ ? -1 : STDIN_FILENO, .events = POLLIN, .revents = 0};
  if (ppoll(&input, 1, &timeout, nullptr) <= 0) return std::nullopt;
  std::array<char, 256> block{};
  const ssize_t size = read(STDIN_FILENO, block.data(), block.size());
  if (size <= 0) is_over_ = true;
  if (size > 0) read_.append(block.data(), static_cast<std::size_t>(size));
  return next();
}

std::optional<std::string> Lines::next() {
  const std::size_t end = read_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = read_.substr(0, end);
  read_.erase(0, end + 1);
  return line;
}

}  // namespace bw
