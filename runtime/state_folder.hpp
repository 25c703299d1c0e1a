// Where a program keeps what has to outlive it, by the XDG base directory specification: $XDG_STATE_HOME,
// else ~/.local/state.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace bw {

/// Not made yet. Throws std::runtime_error where neither variable is set. The specification ignores a path
/// that is not absolute.
inline std::filesystem::path state_folder() {
  const auto folder = [](const char* variable) {
    const char* text = std::getenv(variable);
    const std::filesystem::path path = text == nullptr ? "" : text;
    return path.is_absolute() ? path : std::filesystem::path();
  };
  if (const auto state = folder("XDG_STATE_HOME"); !state.empty()) return state / "bandwagon";
  if (const auto home = folder("HOME"); !home.empty()) return home / ".local" / "state" / "bandwagon";
  throw std::runtime_error("there is no folder for what outlives the process: set XDG_STATE_HOME or HOME");
}

}  // namespace bw
