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

/// Runs the graph `yaml` with the script as one more component, after those of the graph.
inline void run_with_script(const std::string& yaml, double seconds, std::function<void(Setup&)> script) {
  std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::replace(name.begin(), name.end(), '/', '_');  // of a test over parameters
  const auto path = std::filesystem::path(::testing::TempDir()) / (name + ".yaml");
  std::ofstream(path) << yaml;
  std::vector<ExtraComponent> extra;
  extra.push_back({"script", std::make_unique<Script>(std::move(script))});
  Host host(load_graph(path, {}), {.clock = ClockMode::lockstep}, std::move(extra));
  host.run(Duration::seconds(seconds));
}

/// Seconds since the start of a lock-step run.
inline double seconds_since_start(Time t) { return (t - LockstepRunner::kStart).to_seconds(); }

}  // namespace bw
