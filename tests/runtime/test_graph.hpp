// A graph of scripted components that publish numbers, for tests of the host.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <std_msgs/msg/float64.hpp>

#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/parameters/yaml_file.hpp"
#include "tests/runtime/scripted.hpp"

namespace bw {

inline std_msgs::msg::Float64 value(double x) {
  std_msgs::msg::Float64 message;
  message.data(x);
  return message;
}

/// A graph of scripted components, in rank order.
class TestGraph {
 public:
  TestGraph& add(ComponentNode node, std::function<void(Setup&)> script) {
    graph_.components.push_back(scripted(std::move(node), std::move(script)));
    return *this;
  }
  /// Of its section `faults`.
  TestGraph& faults(const std::string& yaml) {
    graph_.shared["faults"] = parse_yaml(yaml, "g.yaml");
    return *this;
  }
  std::string run(double seconds, std::uint64_t seed = 1) {
    Host host(graph_, {.clock = ClockMode::lockstep, .seed = seed});
    end_ = host.run(Duration::seconds(seconds));
    statistics_ = host.statistics();
    return host.samples_sha256();
  }
  const RunEnd& end() const { return end_; }
  const Graph& graph() const { return graph_; }
  const CallbackStatistics& statistics(const std::string& component, const std::string& callback) const {
    for (const auto& s : statistics_) {
      if (s.component == component && s.callback == callback) return s;
    }
    throw std::logic_error("no such callback");
  }

 private:
  Graph graph_;
  RunEnd end_;
  std::vector<CallbackStatistics> statistics_;
};

inline std::int64_t ms(Time t) { return (t - LockstepRunner::kStart).nanoseconds / 1'000'000; }

inline std::function<void(Setup&)> ticker(const std::string& topic, int period_ms) {
  return [=](bw::Setup& setup) {
    setup.every(Duration::milliseconds(period_ms), "tick",
                [out = setup.output<std_msgs::msg::Float64>(topic)](const Tick& tick) mutable {
                  out.publish(value(static_cast<double>(tick.sequence)));
                });
  };
}

}  // namespace bw
