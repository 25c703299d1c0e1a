// Graphs of components whose behaviour are lambdas, and an observer that asks for transitions at set times.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <lifecycle_msgs/srv/change_state.hpp>
#include <std_msgs/msg/float64.hpp>

#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/registry.hpp"

namespace bw::test {

using Float64 = std_msgs::msg::Float64;
using lifecycle_msgs::srv::ChangeState;

inline Float64 value(double x) {
  Float64 message;
  message.data(x);
  return message;
}

inline std::int64_t ms(Time t) { return (t - LockstepRunner::kStart).nanoseconds / 1'000'000; }

/// What happened, in its order: "activate a", "tick a@20".
using Events = std::vector<std::string>;

struct Script {
  std::function<void(Setup&)> configure = [](Setup&) {};
  std::function<void(const Tick&)> activate = [](const Tick&) {};
  std::function<void(const Tick&)> deactivate = [](const Tick&) {};
  std::function<void()> cleanup = [] {};
};

class Scripted final : public Component {
 public:
  explicit Scripted(Script script) : script_(std::move(script)) {}
  void configure(Setup& setup) override { script_.configure(setup); }
  void activate(const Tick& tick) override { script_.activate(tick); }
  void deactivate(const Tick& tick) override { script_.deactivate(tick); }
  void cleanup() override { script_.cleanup(); }

 private:
  Script script_;
};

/// A component that says what is done with it.
inline Script talker(Events& events, const std::string& name) {
  return {.configure = [&events, name](Setup&) { events.push_back("configure " + name); },
          .activate = [&events, name](const Tick&) { events.push_back("activate " + name); },
          .deactivate = [&events, name](const Tick&) { events.push_back("deactivate " + name); },
          .cleanup = [&events, name] { events.push_back("cleanup " + name); }};
}

/// A graph of scripted components in rank order; `make` gives each instance its script.
class ScriptedGraph {
 public:
  ScriptedGraph& add(ComponentNode node, std::function<Script()> make) {
    static int counter = 0;
    node.type = "lifecycle_scripted" + std::to_string(counter++);
    register_component(node.type, [make = std::move(make)] { return std::make_unique<Scripted>(make()); });
    graph.components.push_back(std::move(node));
    return *this;
  }
  ScriptedGraph& add(const std::string& name, std::function<Script()> make) {
    return add(ComponentNode{.name = name}, std::move(make));
  }
  Graph graph;
};

/// Asks for transitions by their labels at times after the start.
class Asker final : public Component {
 public:
  struct Request {
    int at_ms;
    std::string node;
    std::string transition;
  };
  /// `answers`: "deactivate a: ok", "deactivate a: no", "deactivate a: none".
  Asker(std::vector<Request> requests, Events& answers) : requests_(std::move(requests)), answers_(answers) {}

  void configure(Setup& setup) override {
    for (const Request& request : requests_) {
      if (!clients_.contains(request.node))
        clients_[request.node] =
            setup.client<ChangeState>("/" + request.node + "/change_state", Need::optional);
    }
    setup.every(Duration::milliseconds(1), "ask", [this](const Tick& tick) {
      for (const Request& request : requests_) {
        if (request.at_ms == ms(tick.now)) ask(request);
      }
    });
  }

 private:
  void ask(const Request& asked) {
    ChangeState::Request request;
    request.transition().label(asked.transition);
    clients_[asked.node].call(request, Duration::milliseconds(1000),
                              [this, asked](const ChangeState::Response* response, const Tick&) {
                                answers_.push_back(asked.transition + " " + asked.node + ": " +
                                                   (response == nullptr   ? "none"
                                                    : response->success() ? "ok"
                                                                          : "no"));
                              });
  }

  std::vector<Request> requests_;
  Events& answers_;
  std::map<std::string, Client<ChangeState>> clients_;
};

inline std::vector<ExtraComponent> with(std::unique_ptr<Component> observer) {
  std::vector<ExtraComponent> extra;
  extra.push_back({"asker", std::move(observer)});
  return extra;
}

/// Runs in lock-step; the answers to `requests`.
inline Events run(const Graph& graph, double seconds, std::vector<Asker::Request> requests = {},
                  RunEnd* end = nullptr) {
  Events answers;
  Host host(graph, {.clock = ClockMode::lockstep},
            with(std::make_unique<Asker>(std::move(requests), answers)));
  const RunEnd how = host.run(Duration::seconds(seconds));
  if (end != nullptr) *end = how;
  return answers;
}

}  // namespace bw::test
