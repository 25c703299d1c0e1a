// Where Linux tells of devices and processes. Tests look at folders of their own.
#pragma once

#include <filesystem>

namespace bw {

struct SystemFolders {
  std::filesystem::path dev = "/dev";
  std::filesystem::path proc = "/proc";
  std::filesystem::path sys = "/sys";
};

}  // namespace bw
