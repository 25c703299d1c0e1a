// `bandwagon action`: what `ros2 action` does, for machines without ROS 2.
#include <array>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/base/goal_status.hpp"
#include "runtime/cli/action_session.hpp"
#include "runtime/cli/outside.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/yaml_file.hpp"
#include "runtime/ros/message_from_yaml.hpp"
#include "runtime/wire/validate.hpp"
#include "runtime/wire/yaml.hpp"

namespace bw::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct ActionOptions {
  std::string name;
  std::string type;
  std::string goal = "{}";
  std::string distro;
  bool types = false;
  bool json = false;
  bool feedback = false;
  double timeout_s = 5.0;
};

/// Throws with the nearest name.
SeenAction known(Outside& outside, const std::string& name) {
  std::map<std::string, SeenAction> actions;
  outside.settle([&] {
    actions = actions_among(outside.endpoints(true));
    return actions.contains(name);
  });
  const auto found = actions.find(name);
  if (found != actions.end()) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [other, action] : actions) names.push_back(other);
  throw std::runtime_error(name + ": " + unknown_rule("action", name, names));
}

void list(const ActionOptions& options) {
  Outside outside;
  outside.settle();
  const auto actions = actions_among(outside.endpoints(true));
  if (options.json) {
    nlohmann::json json = nlohmann::json::object();
    for (const auto& [name, action] : actions) json[name] = action.type;
    std::cout << json.dump(2) << "\n";
    return;
  }
  for (const auto& [name, action] : actions)
    std::cout << (options.types ? fmt::format("{} [{}]\n", name, action.type) : name + "\n");
}

void info(const ActionOptions& options) {
  Outside outside;
  const SeenAction action = known(outside, options.name);
  std::cout << fmt::format("Action: {}\nType: {}\n", options.name, action.type);
  const auto print = [&](const char* what, const std::vector<dds::Guid>& ends) {
    std::cout << fmt::format("{}: {}\n", what, ends.size());
    for (const dds::Guid& end : ends) std::cout << fmt::format("    {}\n", outside.node_of(end));
  };
  print("Action clients", action.clients);
  print("Action servers", action.servers);
}

/// Of servers that tell no hashes.
RosDistro distro_of(const ActionOptions& options) {
  if (!options.distro.empty()) {
    if (const auto distro = distro_named(options.distro)) return *distro;
    throw std::runtime_error("--distro: " + unknown_rule("distribution", options.distro,
                                                         {"humble", "jazzy", "kilted", "lyrical"}));
  }
  const char* const environment = std::getenv("ROS_DISTRO");
  return distro_named(environment == nullptr ? "" : environment).value_or(RosDistro::jazzy);
}

/// The member of a message, the last one, as it stands in the message's YAML.
std::string last_member(const TypeDescription& type, std::span<const std::uint8_t> cdr) {
  std::string error;
  if (!validate(type, cdr, &error))
    throw std::runtime_error(
        fmt::format("what the server sent is no {}: {}; is it of another distribution (--distro)?",
                    type.ros_name, error));
  const std::string text = to_yaml(type, cdr);
  const std::string line = fmt::format("\n{}:", type.fields.back().name);
  return text.substr(text.rfind(line) + 1);
}

std::string status_text(std::int8_t status) {
  constexpr std::array<const char*, 7> kNames = {"UNKNOWN",   "ACCEPTED", "EXECUTING", "CANCELING",
                                                 "SUCCEEDED", "CANCELED", "ABORTED"};
  const bool is_known = status >= 0 && static_cast<std::size_t>(status) < kNames.size();
  return is_known ? kNames[static_cast<std::size_t>(status)] : std::to_string(status);
}

/// Waits until `seen` gives something; nothing after `limit` or Ctrl-C.
template <class Seen>
auto within(ActionSession& session, Clock::duration limit, Seen look) -> decltype(look()) {
  for (const auto end = Clock::now() + limit; Clock::now() < end && !interrupted(); session.wait()) {
    if (auto value = look()) return value;
  }
  return {};
}

class GoalOfTheShell {
 public:
  GoalOfTheShell(const ActionOptions& options, const ActionLayout& layout, ActionSession& session)
      : options_(options), layout_(layout), session_(session) {}

  /// The exit status.
  int drive(const std::vector<std::uint8_t>& request) {
    const auto limit = std::chrono::milliseconds(static_cast<std::int64_t>(options_.timeout_s * 1e3));
    if (!within(session_, limit, [this] { return session_.is_ready(); })) return fail("is not there");
    session_.send(request);
    const auto accepted = within(session_, limit, [this] { return session_.take_acknowledgement(); });
    // A goal that is accepted after all drives on without us.
    if (!accepted) {
      session_.cancel();
      return fail("did not acknowledge the goal");
    }
    if (!*accepted) {
      std::cout << "Goal was rejected.\n";
      return 1;
    }
    std::cout << "Goal accepted with ID: " << session_.id_text() << std::endl;
    return follow();
  }

 private:
  int fail(const std::string& what) {
    std::cerr << options_.name << " " << what;
    if (!interrupted()) std::cerr << fmt::format(" within {} s", options_.timeout_s);
    std::cerr << "\n";
    return 1;
  }

  int follow() {
    for (bool is_canceling = false;; session_.wait()) {
      print_feedback();
      if (const auto result = session_.take_result()) return finish(*result);
      if (!session_.is_served()) {
        std::cerr << options_.name << ": the server is gone\n";
        return 1;
      }
      if (interrupted() && !is_canceling) {
        is_canceling = true;
        std::cout << "Canceling the goal" << std::endl;
        session_.cancel();
      }
      constexpr std::int8_t kRejected = 1;
      if (session_.take_cancel_code() == kRejected)
        std::cout << "The server refuses to cancel the goal. Ctrl-C leaves it." << std::endl;
    }
  }

  void print_feedback() {
    while (const auto feedback = session_.take_feedback()) {
      if (options_.feedback) std::cout << last_member(*layout_.feedback, *feedback) << "---" << std::endl;
    }
  }

  int finish(const std::vector<std::uint8_t>& response) {
    print_feedback();
    std::cout << last_member(*layout_.get_result_response, response);
    const auto status = static_cast<std::int8_t>(response[4]);  // behind the encapsulation
    std::cout << "Goal finished with status: " << status_text(status) << std::endl;
    return status == static_cast<std::int8_t>(GoalStatus::succeeded) ? 0 : 1;
  }

  const ActionOptions& options_;
  const ActionLayout& layout_;
  ActionSession& session_;
};

/// The request around the goal of the command line.
std::vector<std::uint8_t> request_of(const ActionLayout& layout, const std::string& goal) {
  ConfigEntry entry;
  entry.key = "goal";
  entry.value = parse_yaml(goal, "goal");
  ConfigNode request;
  request.kind = ConfigNode::Kind::kMap;
  request.map.push_back(std::move(entry));
  return message_from_yaml(*layout.send_goal_request, request);
}

int send(ActionOptions options) {
  const RosDistro distro = distro_of(options);
  catch_interrupts();
  Outside outside;
  const SeenAction action = known(outside, options.name);
  if (action.servers.empty()) throw std::runtime_error(options.name + " has clients and no server");
  // One argument behind the name is the goal where it is no type's name.
  if (options.type.find('{') != std::string::npos) options.goal = std::exchange(options.type, "");
  if (!options.type.empty() && options.type != action.type)
    throw std::runtime_error(fmt::format("{} is a {}, not a {}", options.name, action.type, options.type));
  const ActionLayout layout = layout_of(action, distro);
  const std::vector<std::uint8_t> request = request_of(layout, options.goal);
  ActionSession session(outside.participant(), options.name, layout);
  return GoalOfTheShell(options, layout, session).drive(request);
}

void add_action(Verb action) {
  auto options = std::make_shared<ActionOptions>();
  Verb list_verb = action.verb("list", "Names of all actions");
  list_verb.flag("-t,--show-types", options->types, "With types");
  list_verb.flag("--json", options->json, "As JSON");
  list_verb.run([options] { list(*options); });
  Verb info_verb = action.verb("info", "Type, servers and clients of an action");
  info_verb.option("ACTION", options->name, "Name, such as /navigate_to_pose").required();
  info_verb.run([options] { info(*options); });
  Verb send_verb = action.verb(
      "send",
      "Sends a goal and prints its result; Ctrl-C cancels it and waits. Exit status 0 if it succeeded, else 1");
  send_verb.alias("send_goal");
  send_verb.option("ACTION", options->name, "Name, such as /navigate_to_pose").required();
  send_verb.option("TYPE", options->type,
                   "Type, such as nav2_msgs/action/NavigateToPose; default: as offered");
  send_verb.option("GOAL", options->goal, "Its fields as YAML; what is not given is zero");
  send_verb.flag("-f,--feedback", options->feedback, "Prints the feedback");
  send_verb.option("--timeout", options->timeout_s, "Longest wait for the server's acknowledgement [s]");
  send_verb.option("--distro", options->distro,
                   "Whose nav2_msgs the server has where it tells no type hash, as in Humble: humble, jazzy, "
                   "kilted, lyrical; default: ROS_DISTRO, or jazzy");
  send_verb.run([options] { return send(*options); });
}

}  // namespace

BW_VERB(look, "action", "Actions on the wire", add_action)

}  // namespace bw::cli
