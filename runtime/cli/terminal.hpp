// The terminal of a verb that runs for long: one refreshing line, and keys as they are pressed.
#pragma once

#include <optional>
#include <string>

#include <termios.h>

#include "runtime/base/time.hpp"
#include "runtime/cli/standard_input.hpp"

namespace bw::cli {

/// A line on stderr that is written over; nothing where stderr is no terminal.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& text);

 private:
  bool is_terminal_;
  bool is_shown_ = false;
};

/// A character, or one of those that have none.
using Key = int;
inline constexpr Key kUp = 256, kDown = 257, kLeft = 258, kRight = 259, kOtherKey = 260;

/// Keys of stdin without Enter and echo, where it is a terminal; it is as it was when this object goes.
/// Ctrl-C stays a signal; the keys that would kill or suspend the program and leave the terminal so are keys
/// as all others.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  [[nodiscard]] bool is_there() const { return before_.has_value(); }
  /// The next key; nothing when none came within `limit`. Without a terminal, or when it is gone, it only
  /// waits.
  std::optional<Key> wait(Duration limit);

 private:
  Key next_key();

  StandardInput input_;
  std::optional<termios> before_;
  std::string pressed_;  ///< and not yet returned
};

}  // namespace bw::cli
