// This project's folder in one of the XDG base directories.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace bw {

/// $VARIABLE/bandwagon, else ~/BELOW_HOME/bandwagon; empty where neither is set. The specification ignores a
/// path that is not absolute.
inline std::filesystem::path xdg_folder(const char* variable, const char* below_home) {
  const auto folder = [](const char* name) {
    const char* text = std::getenv(name);
    const std::filesystem::path path = text == nullptr ? "" : text;
    return path.is_absolute() ? path : std::filesystem::path();
  };
  if (const auto base = folder(variable); !base.empty()) return base / "bandwagon";
  const auto home = folder("HOME");
  return home.empty() ? home : home / below_home / "bandwagon";
}

}  // namespace bw
