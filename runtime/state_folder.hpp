// Where a program keeps what has to outlive it: $XDG_STATE_HOME, else ~/.local/state.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "runtime/parameters/xdg_folder.hpp"

namespace bw {

/// Not made yet. Throws std::runtime_error where neither variable is set.
inline std::filesystem::path state_folder() {
  auto folder = xdg_folder("XDG_STATE_HOME", ".local/state");
  if (folder.empty())
    throw std::runtime_error("there is no folder for what outlives the process: set XDG_STATE_HOME or HOME");
  return folder;
}

}  // namespace bw
