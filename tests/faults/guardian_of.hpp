// Finds the guardian of a port by who started it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <sys/types.h>

namespace bw::test {

/// The guardian that process `parent` started; -1: there is none.
inline pid_t guardian_of(pid_t parent) {
  const std::string wanted = std::string("bandwagon_port_guardian") + '\0' + std::to_string(parent) + '\0';
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    std::string words;
    std::getline(std::ifstream(entry.path() / "cmdline"), words);  // nothing of one that ends meanwhile
    if (words.starts_with(wanted)) return std::atoi(entry.path().filename().c_str());
  }
  return -1;
}

}  // namespace bw::test
