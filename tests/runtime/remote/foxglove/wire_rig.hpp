// A WireRobot with a listener that remembers, on the test's own thread; and a small robot to be looked at.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/host/host.hpp"
#include "runtime/remote/foxglove/wire_robot.hpp"
#include "tests/interop/eventually.hpp"

namespace bw::foxglove::test {

inline dds::Network network() { return dds::Network::from_environment(dds::Transport::localhost); }

/// What the listener heard.
class Heard final : public RobotListener {
 public:
  struct Message {
    std::uint32_t channel;
    Time received;
    Bytes cdr;
  };
  std::map<std::uint32_t, Channel> channels;
  std::map<std::uint32_t, Service> services;
  std::vector<Message> messages;
  std::vector<Time> times;
  std::vector<NamedValue> parameters;
  std::vector<std::string> statuses;
  std::vector<std::string> order;  ///< of times and messages
  int graphs = 0;

  void on_channels(const std::vector<Channel>& added, const std::vector<std::uint32_t>& removed) override {
    for (const Channel& one : added) channels[one.id] = one;
    for (const std::uint32_t id : removed) channels.erase(id);
  }
  void on_services(const std::vector<Service>& added, const std::vector<std::uint32_t>& removed) override {
    for (const Service& one : added) services[one.id] = one;
    for (const std::uint32_t id : removed) services.erase(id);
  }
  void on_message(std::uint32_t channel, Time received, const SharedBytes& cdr) override {
    messages.push_back({channel, received, *cdr});
    order.emplace_back("message");
  }
  void on_time(Time now) override {
    times.push_back(now);
    order.emplace_back("time");
  }
  void on_graph() override { ++graphs; }
  void on_parameters(const std::vector<NamedValue>& changed) override {
    parameters.insert(parameters.end(), changed.begin(), changed.end());
  }
  void on_status(int, const std::string& message) override { statuses.push_back(message); }

  const Channel* channel(const std::string& topic) const {
    for (const auto& [id, one] : channels) {
      if (one.topic == topic) return &one;
    }
    return nullptr;
  }
  const Service* service(const std::string& name) const {
    for (const auto& [id, one] : services) {
      if (one.name == name) return &one;
    }
    return nullptr;
  }
  std::vector<Bytes> of(std::uint32_t id) const {
    std::vector<Bytes> all;
    for (const Message& one : messages) {
      if (one.channel == id) all.push_back(one.cdr);
    }
    return all;
  }
};

class Rig {
 public:
  explicit Rig(WireRobotOptions options = {}) {
    options.network = network();
    robot = std::make_unique<WireRobot>(std::move(options), [queue = queue_](std::function<void()> work) {
      const std::lock_guard lock(queue->mutex);
      queue->work.push_back(std::move(work));
    });
    robot->set_listener(&heard);
  }

  /// Does the server's work until the condition holds; false after 30 s.
  bool until(const std::function<bool()>& condition) {
    return bw::test::eventually([&] {
      pump();
      return condition();
    });
  }
  /// The id of a topic's channel, as soon as it is there; 0 if it never is.
  std::uint32_t channel(const std::string& topic) {
    return until([&] { return heard.channel(topic) != nullptr; }) ? heard.channel(topic)->id : 0;
  }
  std::uint32_t service(const std::string& name) {
    return until([&] { return heard.service(name) != nullptr; }) ? heard.service(name)->id : 0;
  }
  void pump() {
    std::vector<std::function<void()>> due;
    {
      const std::lock_guard lock(queue_->mutex);
      due.swap(queue_->work);
    }
    for (const auto& one : due) one();
  }

  Heard heard;

 private:
  struct Queue {
    std::mutex mutex;
    std::vector<std::function<void()>> work;
  };
  std::shared_ptr<Queue> queue_ = std::make_shared<Queue>();

 public:
  std::unique_ptr<WireRobot> robot;
};

/// A graph that runs until this ends.
class Running {
 public:
  explicit Running(Graph graph, HostOptions options = {}) : host_(std::move(graph), std::move(options)) {
    thread_ = std::thread([this] { host_.run(std::nullopt); });
  }
  ~Running() {
    host_.finish({.ok = true, .reason = "done"}, true);
    thread_.join();
  }

 private:
  Host host_;
  std::thread thread_;
};

}  // namespace bw::foxglove::test
