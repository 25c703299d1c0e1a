// What a component says to people: one line on the terminal and one rcl_interfaces/Log on /rosout.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include <fmt/core.h>

namespace bw {

/// Levels of rcl_interfaces/msg/Log.
enum class LogLevel : std::uint8_t { debug = 10, info = 20, warn = 30, error = 40, fatal = 50 };

class Logger {
 public:
  using Sink = std::function<void(LogLevel, const std::string& text)>;

  Logger() = default;
  explicit Logger(Sink sink) : sink_(std::move(sink)) {}

  template <class... Args>
  void debug(fmt::format_string<Args...> text, Args&&... args) const {
    write(LogLevel::debug, fmt::format(text, std::forward<Args>(args)...));
  }
  template <class... Args>
  void info(fmt::format_string<Args...> text, Args&&... args) const {
    write(LogLevel::info, fmt::format(text, std::forward<Args>(args)...));
  }
  template <class... Args>
  void warn(fmt::format_string<Args...> text, Args&&... args) const {
    write(LogLevel::warn, fmt::format(text, std::forward<Args>(args)...));
  }
  template <class... Args>
  void error(fmt::format_string<Args...> text, Args&&... args) const {
    write(LogLevel::error, fmt::format(text, std::forward<Args>(args)...));
  }

 private:
  void write(LogLevel level, const std::string& text) const {
    if (sink_) sink_(level, text);
  }

  Sink sink_;
};

}  // namespace bw
