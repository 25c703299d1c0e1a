// `bandwagon run` on drive.yaml in real time, as a process of its own.
#pragma once

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/interop/process.hpp"

namespace bw::test {

/// drive.yaml for a ROS distribution, as a file of this test's own.
inline std::string graph_for(const std::string& distro) {
  const std::string source = BANDWAGON_SOURCE_DIR;
  std::ifstream file(source + "/tests/interop/drive.yaml");
  std::string text = (std::ostringstream() << file.rdbuf()).str();
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("jazzy", distro);
  replace("../..", source);
  const std::string path = std::filesystem::temp_directory_path() / ("drive_" + distro + ".yaml");
  std::ofstream(path) << text;
  return path;
}

class RunningGraph {
 public:
  explicit RunningGraph(const std::string& distro = "jazzy")
      : process_({BANDWAGON_PROGRAM, "run", graph_for(distro), "--for", "120"}) {}
  /// Another graph; it stays up after its goal.
  explicit RunningGraph(const std::filesystem::path& graph)
      : process_({BANDWAGON_PROGRAM, "run", graph.string(), "--for", "120", "--stay"}) {}

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
