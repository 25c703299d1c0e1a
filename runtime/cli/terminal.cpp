#include "runtime/cli/terminal.hpp"

#include <array>
#include <iostream>
#include <string_view>
#include <utility>

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
  if (isatty(STDIN_FILENO) == 0 || tcgetpgrp(STDIN_FILENO) != getpgrp() ||
      tcgetattr(STDIN_FILENO, &now) != 0) {
    input_.ignore();
    return;
  }
  before_ = now;
  now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  for (const int name : {VQUIT, VSUSP}) now.c_cc[name] = _POSIX_VDISABLE;
  tcsetattr(STDIN_FILENO, TCSANOW, &now);
}

Keyboard::~Keyboard() {
  if (before_) tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
}

std::optional<Key> Keyboard::wait(Duration limit) {
  if (!pressed_.empty()) return next_key();
  auto bytes = input_.wait(limit);
  if (input_.is_over()) before_.reset();  // the terminal is gone
  if (!bytes) return std::nullopt;
  pressed_ = std::move(*bytes);
  return next_key();
}

/// Keys that were pressed quickly come together; an arrow is three bytes, and other keys that begin with an
/// escape are one.
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
