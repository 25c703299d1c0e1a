// A robot for clients in other languages: it answers at once, says on standard output what it hears, and does
// what it is told.
#pragma once

#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "runtime/remote/foxglove/parameter_json.hpp"
#include "runtime/remote/foxglove/robot.hpp"

namespace bw::foxglove::test {

using nlohmann::json;

class EchoRobot final : public Robot {
 public:
  void set_listener(RobotListener* listener) override {
    listener_ = listener;
    if (listener == nullptr) return;
    listener->on_channels({{1, "/odom", "std_msgs/msg/String", "string data\n", false},
                           {2, "/map", "std_msgs/msg/String", "string data\n", true}},
                          {});
    listener->on_services({echo(5, "/echo"), echo(6, "/broken")}, {});
  }
  void subscribe(std::uint32_t channel) override { said({{"subscribe", channel}}); }
  void unsubscribe(std::uint32_t channel) override { said({{"unsubscribe", channel}}); }
  std::vector<std::pair<Time, SharedBytes>> latched(std::uint32_t channel) const override {
    if (channel != 2) return {};
    return {{Time::seconds(1), bytes("map")}};
  }
  std::optional<std::string> advertise(const std::string& topic, const std::string& type) override {
    if (type == "unknown_msgs/msg/Type") return type + " is not known";
    said({{"advertise", topic}, {"type", type}});
    return std::nullopt;
  }
  void unadvertise(const std::string& topic) override { said({{"unadvertise", topic}}); }
  std::optional<std::string> publish(const std::string& topic, std::span<const std::uint8_t> cdr) override {
    said({{"publish", topic}, {"bytes", std::vector<int>(cdr.begin(), cdr.end())}});
    return std::nullopt;
  }
  std::optional<std::string> publish_json(const std::string& topic, std::string_view text) override {
    if (!json::accept(text)) return "no JSON";
    said({{"publish", topic}, {"json", json::parse(text)}});
    return std::nullopt;
  }
  void call(std::uint32_t service, std::span<const std::uint8_t> cdr, Answer answer) override {
    reply(service, {cdr.begin(), cdr.end()}, answer);
  }
  void call_json(std::uint32_t service, std::string_view text, Answer answer) override {
    reply(service, {text.begin(), text.end()}, answer);
  }
  void get_parameters(const std::vector<std::string>& names, Values values) override {
    std::vector<NamedValue> found;
    std::vector<std::string> errors;
    for (const auto& [name, value] : parameters_) {
      if (names.empty()) found.push_back({name, value});
    }
    for (const std::string& name : names) {
      if (parameters_.contains(name))
        found.push_back({name, parameters_.at(name)});
      else
        errors.push_back(name + ": no such parameter");
    }
    values(found, errors);
  }
  void set_parameters(const std::vector<NamedValue>& parameters, Values values) override {
    std::vector<NamedValue> changed, held;
    std::vector<std::string> errors;
    for (const NamedValue& parameter : parameters) {
      if (parameter.name == "/node.fixed") {
        errors.emplace_back("/node.fixed: may not change");
        held.push_back({parameter.name, parameters_.at(parameter.name)});
        continue;
      }
      if (type_of(parameter.value) == ParameterType::not_set)
        parameters_.erase(parameter.name);
      else
        parameters_[parameter.name] = parameter.value;
      changed.push_back(parameter);
      held.push_back(parameter);
    }
    values(held, errors);
    listener_->on_parameters(changed);
  }
  ConnectionGraph graph() const override { return graph_; }
  std::map<std::string, std::string> metadata() const override { return {{"ROS_DISTRO", "jazzy"}}; }

  /// What the test wants to happen.
  void obey(const json& order) {
    const std::string what = order.at("do");
    if (what == "message")
      listener_->on_message(order.at("channel"), Time::seconds(order.at("time")), bytes(order.at("text")));
    if (what == "time") listener_->on_time(Time::seconds(order.at("time")));
    if (what == "status") listener_->on_status(order.at("level"), order.at("text"));
    if (what == "channel")
      listener_->on_channels(
          {{order.at("id"), order.at("topic"), "std_msgs/msg/String", "string data\n", false}}, {});
    if (what == "no channel") listener_->on_channels({}, {order.at("id").get<std::uint32_t>()});
    if (what == "service") listener_->on_services({echo(order.at("id"), order.at("name"))}, {});
    if (what == "no service") listener_->on_services({}, {order.at("id").get<std::uint32_t>()});
    if (what == "graph") {
      graph_ = {order.at("published"), order.at("subscribed"), order.at("services")};
      listener_->on_graph();
    }
  }

 private:
  static SharedBytes bytes(const std::string& text) {
    return std::make_shared<const Bytes>(text.begin(), text.end());
  }
  static Service echo(std::uint32_t id, const std::string& name) {
    return {id,
            name,
            "test_msgs/srv/Echo",
            {"test_msgs/srv/Echo_Request", "string data\n"},
            {"test_msgs/srv/Echo_Response", "string data\n"}};
  }
  static void said(const json& words) {
    std::printf("%s\n", words.dump().c_str());
    std::fflush(stdout);
  }
  static void reply(std::uint32_t service, Bytes request, const Answer& answer) {
    if (service == 6)
      answer(std::string("no reply"));
    else
      answer(std::move(request));
  }

  RobotListener* listener_ = nullptr;
  ConnectionGraph graph_;
  std::map<std::string, ParameterValue> parameters_ = {{"/node.speed", 0.5},
                                                       {"/node.count", std::int64_t{3}},
                                                       {"/node.bytes", std::vector<std::uint8_t>{16, 32, 48}},
                                                       {"/node.fixed", true}};
};

}  // namespace bw::foxglove::test
