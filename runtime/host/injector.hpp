// The faults of a graph in one process, while it runs: between components and the wire, in their clocks, on their lanes. Tells
// on /faults when each begins and ends, and in the diagnostics which act.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>

#include "runtime/component.hpp"
#include "runtime/host/actor.hpp"
#include "runtime/host/injected_fault.hpp"

namespace bw {

class Runner;

class Injector final : public Component, public OutputGate {
 public:
  /// `around` holds all actors; ends of those in `local` are changed, who live as long as this. Throws ConfigError.
  Injector(const FaultSurroundings& around, const std::vector<Actor*>& local, std::string process);

  /// No fault is of this process.
  [[nodiscard]] bool is_idle() const { return faults_.empty(); }

  /// By name: what, where and when.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> in_words() const;

  void configure(Setup& setup) override;
  /// Before anything of the run happens. `start`: of the run, on its clock. Throws ConfigError where a fault needs `bandwagon
  /// launch` and there is none.
  void begin(Runner& runner, Time start);
  void pass(OutputEnd& output, std::span<const std::uint8_t> cdr) override;

 private:
  struct Held {
    Time due;
    std::uint64_t sequence = 0;
    OutputEnd* output = nullptr;
    std::vector<std::uint8_t> cdr;
  };
  /// A fault that begins and ends on a component's lane.
  struct Edges {
    InjectedFault* fault = nullptr;
    Timer* timer = nullptr;
    std::int64_t occurrence = 0;
    bool is_begun = false;
  };

  void place_gates(InjectedFault& fault);
  void place_edges(InjectedFault& fault);
  void cross(Edges& edges, Time now);
  void plan(const Edges& edges);
  /// What becomes of it now; nothing: it is lost, or comes later.
  std::optional<std::vector<std::uint8_t>> changed(OutputEnd& output, std::span<const std::uint8_t> cdr);
  void step(Time now);
  void say_again(Time now);
  void release(Time now);
  /// Once for each beginning and end.
  void tell(const InjectedFault& fault, const FaultTick& tick);

  std::vector<std::unique_ptr<InjectedFault>> faults_;
  const std::vector<Actor*>& local_;
  std::string process_;
  bool is_lockstep_;
  Runner* runner_ = nullptr;
  Time start_;  ///< of the run
  Time began_;  ///< of this process
  std::vector<std::unique_ptr<Edges>> edges_;
  std::map<const OutputEnd*, std::vector<std::pair<InjectedFault*, InjectedFault::Gate*>>> gates_;
  std::mutex mutex_;  ///< of what faults keep, and of all below
  std::vector<Held> held_;
  std::map<OutputEnd*, std::vector<std::uint8_t>> last_;  ///< as it was published, of topics that hold
  std::map<OutputEnd*, bool> said_again_;
  std::uint64_t sequence_ = 0;
  std::map<const InjectedFault*, std::pair<std::int64_t, bool>> told_;
  DiagnosticReporter* diagnostics_ = nullptr;
  Logger log_;
  Output<diagnostic_msgs::msg::DiagnosticArray> out_;
};

}  // namespace bw
