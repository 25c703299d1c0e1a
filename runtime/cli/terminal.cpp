#include "runtime/cli/terminal.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>

#include <poll.h>
#include <unistd.h>

namespace bw::cli {

ProgressLine::ProgressLine() : is_terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (is_shown_) std::cerr << std::endl;
}

void ProgressLine::show(const std::string& text) {
  if (!is_terminal_) return;
  is_shown_ = true;
  std::cerr << "\r" << text << "\x1b[K" << std::flush;  // the escape clears what a longer line left
}

Keyboard::Keyboard() {
  termios now{};
  // A job in the background would be stopped by touching the terminal.
  if (isatty(STDIN_FILENO) == 0 || tcgetpgrp(STDIN_FILENO) != getpgrp() || tcgetattr(STDIN_FILENO, &now) != 0)
    return;
  before_ = now;
  now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  for (const int name : {VQUIT, VSUSP}) now.c_cc[name] = _POSIX_VDISABLE;
  tcsetattr(STDIN_FILENO, TCSANOW, &now);
}

Keyboard::~Keyboard() {
  if (before_) tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
}

std::optional<Key> Keyboard::wait(Duration limit) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  if (!pressed_.empty()) return next_key();
  const std::int64_t ns = std::max<std::int64_t>(limit.nanoseconds, 0);
  const timespec timeout{.tv_sec = ns / kSecond, .tv_nsec = ns % kSecond};
  pollfd input{.fd = is_there() ? STDIN_FILENO : -1, .events = POLLIN, .revents = 0};
  if (ppoll(&input, 1, &timeout, nullptr) <= 0) return std::nullopt;
  std::array<char, 64> bytes{};
  const ssize_t size = read(STDIN_FILENO, bytes.data(), bytes.size());
  if (size <= 0) {
    before_.reset();  // the terminal is gone
    return std::nullopt;
  }
  pressed_.assign(bytes.data(), static_cast<std::size_t>(size));
  return next_key();
}

/// Keys that were pressed quickly come together; an arrow is three bytes, and other keys that begin with an escape are one.
Key Keyboard::next_key() {
  struct Name {
    std::string_view bytes;
    Key key;
  };
  constexpr std::array kNames = {Name{"\x1b[A", kUp},   Name{"\x1bOA", kUp},    Name{"\x1b[B", kDown},
                                 Name{"\x1bOB", kDown}, Name{"\x1b[C", kRight}, Name{"\x1bOC", kRight},
                                 Name{"\x1b[D", kLeft}, Name{"\x1bOD", kLeft}};
  for (const Name& name : kNames) {
    if (!pressed_.starts_with(name.bytes)) continue;
    pressed_.erase(0, name.bytes.size());
    return name.key;
  }
  const char first = pressed_.front();
  if (first == '\x1b') {
    pressed_.clear();
    return kOtherKey;
  }
  pressed_.erase(0, 1);
  return static_cast<unsigned char>(first);
}

}  // namespace bw::cli
