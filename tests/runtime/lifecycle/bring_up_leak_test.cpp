// Up and down many times in one process: what was taken is given back.
#include <array>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "runtime/dds/participant.hpp"
#include "runtime/process_memory.hpp"
#include "tests/runtime/lifecycle/scripted_graph.hpp"

namespace bw::test {
namespace {

std::size_t threads() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

struct Use {
  std::size_t threads = 0;
  std::size_t endpoints = 0;
  double memory_mb = 0.0;
};

/// Takes every component of three down to unconfigured and up again, and looks what the process has before
/// and after. What a second participant sees counts, once nothing new has come for a while.
class Cycler final : public Component {
 public:
  Cycler(int cycles, const dds::Participant& watcher, std::vector<Use>& uses)
      : left_(cycles), watcher_(watcher), uses_(uses) {}

  void configure(Setup& setup) override {
    finish_ = setup.finish_run();
    for (const char* node : {"a", "b", "c"})
      clients_.push_back(
          setup.client<ChangeState>(std::string("/") + node + "/change_state", Need::optional));
    setup.every(Duration::milliseconds(300), "look", [this](const Tick&) {
      const std::uint64_t changes = watcher_.endpoint_changes();
      if (std::exchange(changes_, changes) != changes || changes == 0 || is_cycling_) return;
      uses_.push_back({threads(), watcher_.endpoints().size(), memory_mb()});
      if (left_ == 0) return finish_(true, "done");
      is_cycling_ = true;
      step();
    });
  }

 private:
  void step() {
    static constexpr std::array kCycle = {"deactivate", "cleanup", "configure", "activate"};
    ChangeState::Request request;
    request.transition().label(kCycle[at_ / clients_.size()]);
    clients_[at_ % clients_.size()].call(request, Duration::seconds(20.0),
                                         [this](const auto* response, const Tick&) {
                                           if (response == nullptr || !response->success())
                                             return finish_(false, "a transition failed");
                                           if (++at_ == kCycle.size() * clients_.size()) {
                                             at_ = 0;
                                             is_cycling_ = --left_ > 0;
                                           }
                                           if (is_cycling_) step();
                                         });
  }

  int left_;
  bool is_cycling_ = false;
  std::size_t at_ = 0;
  const dds::Participant& watcher_;
  std::uint64_t changes_ = 0;
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

TEST(BringUps, AHundredLeaveNothingBehind) {
  ScriptedGraph g;
  for (const char* name : {"a", "b", "c"}) g.add(name, hungry);
  const dds::Participant watcher({.network = dds::Network::from_environment({})});
  std::vector<Use> uses;
  Host host(g.graph, {.clock = ClockMode::wall}, with(std::make_unique<Cycler>(100, watcher, uses)));
  EXPECT_EQ(host.run(Duration::seconds(60.0)).reason, "done");
  ASSERT_EQ(uses.size(), 2U);
  // One kept at each bring-up of each component were 300 more; the watcher may have missed a few at first.
  EXPECT_LT(uses[1].threads, uses[0].threads + 10);
  EXPECT_LT(uses[1].endpoints, uses[0].endpoints + 10);
  // An instance has 1 MB, so that 300 kept ones were 300 MB; the allocator may hold some of them back.
  const double growth_mb = uses[1].memory_mb - uses[0].memory_mb;
  EXPECT_LT(growth_mb, 10.0);
  std::cout << uses[0].endpoints << " to " << uses[1].endpoints << " endpoints, " << uses[0].threads << " to "
            << uses[1].threads << " threads, " << growth_mb << " MB more\n";
}

}  // namespace
}  // namespace bw::test
