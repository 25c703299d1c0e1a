// A component of the program on its real topics in lock-step, with a script in place of its neighbours.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "runtime/component.hpp"
#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"

namespace bw {

/// A component whose configure() is a lambda.
class Script final : public Component {
 public:
  explicit Script(std::function<void(Setup&)> configure) : configure_(std::move(configure)) {}
  void configure(Setup& setup) override { configure_(setup); }

 private:
  std::function<void(Setup&)> configure_;
};

/// A file for this process alone: programs of one test run share the folder.
inline std::filesystem::path scratch_file(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / (name + "_" + std::to_string(getpid()) + ".yaml");
}

/// Runs the graph `yaml` with the script as one more component, after those of the graph.
inline void run_with_script(const std::string& yaml, double seconds, std::function<void(Setup&)> script) {
  std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::replace(name.begin(), name.end(), '/', '_');  // of a test over parameters
  const auto path = scratch_file(name);
  std::ofstream(path) << yaml;
  std::vector<ExtraComponent> extra;
  extra.push_back({"script", std::make_unique<Script>(std::move(script))});
  Host host(load_graph(path, {}), {.clock = ClockMode::lockstep}, std::move(extra));
  const RunEnd end = host.run(Duration::seconds(seconds));
  EXPECT_FALSE(end.has_thrown) << end.reason;
  std::filesystem::remove(path);
}

/// Seconds since the start of a lock-step run.
inline double seconds_since_start(Time t) { return (t - LockstepRunner::kStart).to_seconds(); }

}  // namespace bw
