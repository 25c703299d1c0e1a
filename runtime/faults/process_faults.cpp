// Kinds of faults of a process, for one that somebody starts again: `bandwagon launch`. Each is bounded in time, and in size.
#include <algorithm>
#include <csignal>
#include <cstddef>
#include <memory>
#include <vector>

#include "runtime/fault.hpp"
#include "runtime/host/statistics.hpp"

namespace bw {
namespace {

constexpr auto kNothing = [](const FaultTick&) {};

struct ProcessKilled final : Fault {
  void configure(FaultSetup& setup) override {
    setup.is_of_a_process(false);
    setup.begins_and_ends([](const FaultTick&) { raise(SIGKILL); }, kNothing);
  }
};

struct ProcessStopped final : Fault {
  void configure(FaultSetup& setup) override {
    setup.is_of_a_process(false);
    setup.begins_and_ends([](const FaultTick&) { raise(SIGSTOP); }, kNothing);
  }
};

struct SpinParameters {
  double most = 5.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("most", most, {.unit = "s", .min = 0.1, .max = 60, .doc = "then it goes on, if nobody has ended it"});
  }
};

struct ProcessSpins final : Fault {
  void configure(FaultSetup& setup) override {
    const Duration most = Duration::seconds(setup.parameters<SpinParameters>().most);
    setup.is_of_a_process(false);
    setup.begins_and_ends(
        [most](const FaultTick&) {
          for (const Duration end = steady_time() + most; steady_time() < end;) {
          }
        },
        kNothing);
  }
};

struct LeakParameters {
  double rate = 200.0, most = 2000.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "MB/s", .min = 1, .max = 10'000, .doc = "that it takes and keeps"});
    v("most", most, {.unit = "MB", .min = 1, .max = 100'000, .doc = "then it takes no more"});
  }
};

struct ProcessLeaks final : Fault {
  void configure(FaultSetup& setup) override {
    const auto options = setup.parameters<LeakParameters>();
    setup.is_of_a_process(true);
    setup.acts([this, options](const FaultTick& tick) {
      constexpr std::size_t kBlock = 1'000'000;
      constexpr double kAtOnce = 0.02;  // [s] of the rate: who leaks does not hang
      const auto have = static_cast<double>(kept_.size());
      const double wanted =
          std::min({options.most, options.rate * tick.since.to_seconds(), have + options.rate * kAtOnce});
      while (static_cast<double>(kept_.size()) < wanted) kept_.emplace_back(kBlock, char{1});
    });
  }
  std::vector<std::vector<char>> kept_;
};

}  // namespace

BW_FAULT(ProcessKilled, "process_killed", "SIGKILL (under launch)")
BW_FAULT(ProcessStopped, "process_stopped", "SIGSTOP: it hangs, whole (under launch)")
BW_FAULT(ProcessSpins, "process_spins", "the lane of a component does not come back (under launch)")
BW_FAULT(ProcessLeaks, "process_leaks", "it takes memory until its limit (under launch, with a limit)")

}  // namespace bw
