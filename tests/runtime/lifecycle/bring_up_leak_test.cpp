// Up and down many times in one process: what was taken is given back.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "runtime/dds/participant.hpp"
#include "tests/runtime/lifecycle/scripted_graph.hpp"

namespace bw::test {
namespace {

std::size_t threads() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  std::size_t total = 0, resident = 0;
  statm >> total >> resident;
  return static_cast<double>(resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) / 1e6;
}

struct Use {
  std::size_t threads = 0;
  std::size_t endpoints = 0;
  double memory_mb = 0.0;
};

/// Takes every component of three down to unconfigured and up again, and looks what the process has by then.
class Cycler final : public Component {
 public:
  Cycler(int cycles, const dds::Participant& watcher, std::vector<Use>& uses)
      : left_(cycles), watcher_(watcher), uses_(uses) {}

  void configure(Setup& setup) override {
    finish_ = setup.finish_run();
    for (const char* node : {"a", "b", "c"})
      clients_.push_back(
          setup.client<ChangeState>(std::string("/") + node + "/change_state", Need::optional));
    setup.every(Duration::milliseconds(1), "begin", [this](const Tick& tick) {
      if (tick.sequence == 0) step();
    });
  }

 private:
  void step() {
    static constexpr std::array kCycle = {"deactivate", "cleanup", "configure", "activate"};
    ChangeState::Request request;
    request.transition().label(kCycle[at_ / clients_.size()]);
    clients_[at_ % clients_.size()].call(
        request, Duration::seconds(20.0), [this](const auto* response, const Tick&) {
          if (response == nullptr || !response->success()) return finish_(false, "a transition failed");
          if (++at_ < kCycle.size() * clients_.size()) return step();
          at_ = 0;
          uses_.push_back({threads(), watcher_.endpoints().size(), resident_mb()});
          if (--left_ == 0) return finish_(true, "done");
          step();
        });
  }

  int left_;
  std::size_t at_ = 0;
  const dds::Participant& watcher_;
  std::vector<Use>& uses_;
  std::vector<Client<ChangeState>> clients_;
  std::function<void(bool, const std::string&)> finish_;
};

/// Allocates 1 MB per instance, so that an instance that is kept would be seen.
Script hungry() {
  auto memory = std::make_shared<std::vector<char>>();
  return {.configure = [memory](Setup& setup) {
    memory->assign(1'000'000, 'x');
    setup.input<Float64>(
        "in", Qos::latched(), [memory](const Float64&, const Tick&) {}, Need::optional);
    setup.every(Duration::milliseconds(5), "tick",
                [out = setup.output<Float64>("~/out")](const Tick&) { out.publish(value(1)); });
  }};
}

// BANDWAGON_BRING_UPS asks for more than CTest does.
TEST(BringUps, LeaveNothingBehind) {
  const char* asked = std::getenv("BANDWAGON_BRING_UPS");
  const int cycles = asked != nullptr ? std::max(2, std::atoi(asked)) : 20;
  ScriptedGraph g;
  for (const char* name : {"a", "b", "c"}) g.add(name, hungry);
  const dds::Participant watcher({.network = dds::Network::from_environment({})});
  std::vector<Use> uses;
  Host host(g.graph, {.clock = ClockMode::wall}, with(std::make_unique<Cycler>(cycles, watcher, uses)));
  EXPECT_EQ(host.run(Duration::seconds(60.0)).reason, "done");
  ASSERT_EQ(uses.size(), static_cast<std::size_t>(cycles));
  EXPECT_EQ(uses.back().threads, uses.front().threads);
  // The watcher may still be discovering during the first rounds; it never sees more than there are.
  EXPECT_LE(uses.back().endpoints, watcher.endpoints().size());
  std::size_t most = 0;
  for (const Use& use : uses) most = std::max(most, use.endpoints);
  EXPECT_EQ(most, uses.back().endpoints) << "all were there at the end, and no more ever";
  // Three instances of 1 MB each; kept ones would be 3 MB a cycle.
  EXPECT_LT(uses.back().memory_mb - uses.front().memory_mb, 3.0);
  RecordProperty("memory_growth_kb",
                 static_cast<int>(1e3 * (uses.back().memory_mb - uses.front().memory_mb)));
}

}  // namespace
}  // namespace bw::test
