// One of config/graphs/nav2 as a process of its own, and who stands outside: a node that shares nothing with
// the runtime, asks for states as Nav2's lifecycle_manager does and looks at what is there.
#pragma once

#include <algorithm>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include "tests/interop/eventually.hpp"
#include "tests/interop/plain/service.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {

class StandIn {
 public:
  /// `settings`: NAME=VALUE of `--set`.
  explicit StandIn(const std::string& graph, const std::vector<std::string>& settings = {})
      : process_(command(graph, settings)) {}

  Process& process() { return process_; }
  bool says(const std::string& text) {
    return eventually([&] { return process_.err().find(text) != std::string::npos; });
  }
  /// Ctrl-C; the exit status.
  int stop() {
    process_.signal(SIGINT);
    return process_.wait(std::chrono::seconds(20)).value_or(-1);
  }

 private:
  static std::vector<std::string> command(const std::string& graph,
                                          const std::vector<std::string>& settings) {
    std::vector<std::string> words{
        BANDWAGON_PROGRAM, "run",
        std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/nav2/" + graph + ".yaml", "--for", "300"};
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    return words;
  }

  Process process_;
};

/// Ids of lifecycle_msgs.
enum StateId { kUnconfigured = 1, kInactive = 2, kActive = 3 };
enum TransitionId { kConfigure = 1, kCleanup = 2, kActivate = 3, kDeactivate = 4 };

class Outsider {
 public:
  plain::Node& node() { return node_; }

  std::optional<plain::Bytes> call(const std::string& service, const std::string& type,
                                   const plain::Bytes& request = plain::from_hex("0001000000")) {
    plain::Client client(node_, service, {.name = type, .request_hash = {}, .response_hash = {}});
    return client.call(request, std::chrono::seconds(20));
  }
  /// Whether the transition was made.
  bool change(const std::string& node, TransitionId id) {
    // Transition: the id and an empty label, at 4.
    const auto reply = call(node + "/change_state", "lifecycle_msgs/srv/ChangeState",
                            plain::from_hex("00010000 0" + std::to_string(id) + " 000000 01000000 00"));
    return reply && plain::CdrIn(*reply).number<std::uint8_t>() == 1;
  }
  /// 0 when nobody answers.
  int state(const std::string& node) {
    const auto reply = call(node + "/get_state", "lifecycle_msgs/srv/GetState");
    return reply ? plain::CdrIn(*reply).number<std::uint8_t>() : 0;
  }
  bool sees_node(const std::string& name) {
    return eventually(
        [&] { return std::ranges::any_of(node_.nodes(), [&](const auto& n) { return n.name == name; }); });
  }
  /// `type` as ROS 2 writes it: nav_msgs/msg/Path.
  bool sees_topic(const std::string& topic, const std::string& type, bool is_published) {
    return sees("rt" + topic, dds_name(type, "_"), is_published);
  }
  bool sees_service(const std::string& service, const std::string& type) {
    return sees(plain::request_topic(service), dds_name(type, "_Request_"), false) &&
           sees(plain::reply_topic(service), dds_name(type, "_Response_"), true);
  }
  bool sees_action(const std::string& action, const std::string& type) {
    const std::string part = action + "/_action/";
    return sees_service(part + "send_goal", type + "_SendGoal") &&
           sees_service(part + "get_result", type + "_GetResult") &&
           sees_service(part + "cancel_goal", "action_msgs/srv/CancelGoal") &&
           sees_topic(part + "feedback", type + "_FeedbackMessage", true) &&
           sees_topic(part + "status", "action_msgs/msg/GoalStatusArray", true);
  }

  plain::dds::DataReader* listen(const std::string& topic, const std::string& type) {
    auto* reader = node_.create_reader(
        {.topic = "rt" + topic, .type = dds_name(type, "_"), .type_hash = {}, .depth = 100});
    node_.announce();
    return reader;
  }
  plain::dds::DataWriter* speak(const std::string& topic, const std::string& type) {
    auto* writer = node_.create_writer({.topic = "rt" + topic, .type = dds_name(type, "_"), .type_hash = {}});
    node_.announce();
    return writer;
  }
  /// The oldest sample that was not taken; nothing when there is none.
  static std::optional<plain::Bytes> take(plain::dds::DataReader* reader) {
    plain::Bytes bytes;
    plain::dds::SampleInfo info;
    while (bw::fast_dds::is_ok(reader->take_next_sample(&bytes, &info))) {
      if (info.valid_data) return bytes;
    }
    return std::nullopt;
  }
  /// The first sample of which `is_it` holds.
  template <class IsIt>
  static bool hears(plain::dds::DataReader* reader, IsIt is_it) {
    return eventually([&] {
      while (const auto bytes = take(reader)) {
        if (is_it(*bytes)) return true;
      }
      return false;
    });
  }

 private:
  static std::string dds_name(const std::string& type, const std::string& suffix) {
    const std::size_t first = type.find('/'), second = type.rfind('/');
    return type.substr(0, first) + "::" + type.substr(first + 1, second - first - 1) +
           "::dds_::" + type.substr(second + 1) + suffix;
  }
  bool sees(const std::string& topic, const std::string& type, bool is_writer) {
    return eventually([&] {
      const auto ends = node_.ends();
      return std::ranges::any_of(ends, [&](const auto& item) {
        const plain::End& end = item.second;
        return !end.is_own && end.topic == topic && end.type == type && end.is_writer == is_writer;
      });
    });
  }

  plain::Node node_{"outsider"};
};

}  // namespace bw::test
