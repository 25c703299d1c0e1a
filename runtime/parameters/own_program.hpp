// Where the running program lies.
#pragma once

#include <filesystem>
#include <system_error>

namespace bw {

/// Its path, links resolved; empty where /proc does not tell.
inline std::filesystem::path own_program() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown);
}

}  // namespace bw
