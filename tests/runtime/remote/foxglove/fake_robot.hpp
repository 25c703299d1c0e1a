// A robot that remembers what was asked of it and answers when the test says so.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/remote/foxglove/robot.hpp"

namespace bw::foxglove::test {

inline SharedBytes bytes_of(std::string_view text) {
  return std::make_shared<const Bytes>(text.begin(), text.end());
}

inline Channel channel(std::uint32_t id, const std::string& topic, bool is_latched = false) {
  return {id, topic, "std_msgs/msg/String", "string data\n", is_latched};
}

inline Service service(std::uint32_t id, const std::string& name,
                       const std::string& type = "std_srvs/srv/SetBool") {
  return {id,
          name,
          type,
          {type + "_Request", "bool data\n"},
          {type + "_Response", "bool success\nstring message\n"}};
}

class FakeRobot final : public Robot {
 public:
  struct Published {
    std::string topic;
    std::string payload;
    bool is_json = false;
    bool operator==(const Published&) const = default;
  };
  struct Call {
    std::uint32_t service = 0;
    std::string payload;
    bool is_json = false;
    Answer answer;
  };
  struct ParameterRequest {
    std::vector<std::string> names;      ///< of a get
    std::vector<NamedValue> parameters;  ///< of a set
    Values values;
  };

  void set_listener(RobotListener* l) override { listener = l; }
  void subscribe(std::uint32_t channel) override { ++subscribers[channel]; }
  void unsubscribe(std::uint32_t channel) override { --subscribers[channel]; }
  std::vector<std::pair<Time, SharedBytes>> latched(std::uint32_t channel) const override {
    const auto found = last.find(channel);
    return found == last.end() ? std::vector<std::pair<Time, SharedBytes>>() : found->second;
  }
  std::optional<std::string> advertise(const std::string& topic, const std::string& type) override {
    if (refusal) return refusal;
    advertised[topic] = type;
    return std::nullopt;
  }
  void unadvertise(const std::string& topic) override { advertised.erase(topic); }
  std::optional<std::string> publish(const std::string& topic, std::span<const std::uint8_t> cdr) override {
    published.push_back({topic, {cdr.begin(), cdr.end()}, false});
    return refusal;
  }
  std::optional<std::string> publish_json(const std::string& topic, std::string_view json) override {
    published.push_back({topic, std::string(json), true});
    return refusal;
  }
  void call(std::uint32_t service, std::span<const std::uint8_t> cdr, Answer answer) override {
    calls.push_back({service, {cdr.begin(), cdr.end()}, false, std::move(answer)});
  }
  void call_json(std::uint32_t service, std::string_view json, Answer answer) override {
    calls.push_back({service, std::string(json), true, std::move(answer)});
  }
  void get_parameters(const std::vector<std::string>& names, Values values) override {
    gets.push_back({names, {}, std::move(values)});
  }
  void set_parameters(const std::vector<NamedValue>& parameters, Values values) override {
    sets.push_back({{}, parameters, std::move(values)});
  }
  ConnectionGraph graph() const override {
    ++graphs_asked;
    return nodes;
  }
  std::map<std::string, std::string> metadata() const override { return {{"ROS_DISTRO", "jazzy"}}; }

  RobotListener* listener = nullptr;
  std::map<std::uint32_t, int> subscribers;
  std::map<std::uint32_t, std::vector<std::pair<Time, SharedBytes>>> last;
  std::map<std::string, std::string> advertised;
  std::optional<std::string> refusal;
  std::vector<Published> published;
  std::vector<Call> calls;
  std::vector<ParameterRequest> gets;
  std::vector<ParameterRequest> sets;
  ConnectionGraph nodes;
  mutable int graphs_asked = 0;
};

}  // namespace bw::foxglove::test
