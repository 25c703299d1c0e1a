// `bandwagon run` on drive.yaml in real time, as a process of its own.
#pragma once

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/interop/process.hpp"

namespace bw::test {

/// drive.yaml for another ROS distribution, in a folder from which its robot is found too.
inline std::filesystem::path graph_for(const std::string& distro) {
  const std::filesystem::path folder = std::filesystem::path(BANDWAGON_SOURCE_DIR) / "tests/interop";
  std::ifstream file(folder / "drive.yaml");
  std::string text = (std::ostringstream() << file.rdbuf()).str();
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("jazzy", distro);
  replace("../..", BANDWAGON_SOURCE_DIR);
  const std::filesystem::path path =
      std::filesystem::path(BANDWAGON_BINARY_DIR) / ("drive_" + distro + ".yaml");
  std::ofstream(path) << text;
  return path;
}

class RunningGraph {
 public:
  explicit RunningGraph(const std::string& distro = "jazzy")
      : process_({BANDWAGON_PROGRAM, "run", graph_for(distro).string(), "--for", "120"}) {}

  Process& process() { return process_; }

  /// Ctrl-C; the exit status.
  int stop() {
    process_.signal(SIGINT);
    return process_.wait(std::chrono::seconds(20)).value_or(-1);
  }

 private:
  Process process_;
};

}  // namespace bw::test
