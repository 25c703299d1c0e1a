// The robot's side of a Foxglove server: what there is to be heard, asked and changed. `WireRobot`
// (wire_robot.hpp) finds it on the domain; tests of the protocol have one of their own. Bytes are CDR with
// its encapsulation and pass through as they are.
//
// All calls, in both directions, come on one thread: the server's.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/parameters/parameter_set.hpp"

namespace bw::foxglove {

using Bytes = std::vector<std::uint8_t>;
using SharedBytes = std::shared_ptr<const Bytes>;

/// A topic with one type, as long as somebody publishes it. An id stays with its topic and type.
struct Channel {
  std::uint32_t id = 0;
  std::string topic;        ///< /odom
  std::string schema_name;  ///< nav_msgs/msg/Odometry
  std::string schema;       ///< ros2msg text with all it contains
  bool is_latched = false;  ///< somebody publishes it transient-local
};

struct ServiceSchema {
  std::string schema_name;  ///< nav_msgs/srv/LoadMap_Request
  std::string schema;       ///< ros2msg
};

/// An id stays with its name and type. Those of actions are among them: /navigate_to_pose/_action/send_goal.
struct Service {
  std::uint32_t id = 0;
  std::string name;
  std::string type;  ///< nav_msgs/srv/LoadMap
  ServiceSchema request;
  ServiceSchema response;
};

/// Nodes by topic or service, full names.
struct ConnectionGraph {
  std::map<std::string, std::set<std::string>> published;
  std::map<std::string, std::set<std::string>> subscribed;
  std::map<std::string, std::set<std::string>> services;
  bool operator==(const ConnectionGraph&) const = default;
};

/// Hears what changes. `on_time` comes before the messages it belongs to; it may go back.
class RobotListener {
 public:
  virtual ~RobotListener() = default;
  /// A channel that is removed has no subscriptions any more; it may come back, with the same id.
  virtual void on_channels(const std::vector<Channel>& added, const std::vector<std::uint32_t>& removed) = 0;
  virtual void on_services(const std::vector<Service>& added, const std::vector<std::uint32_t>& removed) = 0;
  virtual void on_message(std::uint32_t channel, Time received, const SharedBytes& cdr) = 0;
  virtual void on_time(Time now) = 0;
  virtual void on_graph() = 0;
  virtual void on_parameters(const std::vector<NamedValue>& changed) = 0;
  /// For people: a node that came twice, a type that is not known. Level 0 info, 1 warning, 2 error.
  virtual void on_status(int level, const std::string& message) = 0;
};

class Robot {
 public:
  virtual ~Robot() = default;

  /// Before anything else; what there is already is told at once. Null: nobody listens any more.
  virtual void set_listener(RobotListener* listener) = 0;

  /// Counted: the topic is heard while somebody has subscribed. What nobody hears costs nothing.
  virtual void subscribe(std::uint32_t channel) = 0;
  virtual void unsubscribe(std::uint32_t channel) = 0;
  /// The last messages of a latched topic, one of each publisher; empty where none is known yet.
  virtual std::vector<std::pair<Time, SharedBytes>> latched(std::uint32_t channel) const = 0;

  /// What is wrong with it, or nothing. Types by both spellings: geometry_msgs/PoseStamped,
  /// geometry_msgs/msg/PoseStamped.
  virtual std::optional<std::string> advertise(const std::string& topic, const std::string& type) = 0;
  virtual void unadvertise(const std::string& topic) = 0;
  virtual std::optional<std::string> publish(const std::string& topic, std::span<const std::uint8_t> cdr) = 0;
  /// The same from an object of JSON as Foxglove's panels write it: fields that are not there are zero.
  virtual std::optional<std::string> publish_json(const std::string& topic, std::string_view json) = 0;

  using Answer = std::function<void(const std::variant<Bytes, std::string>& reply_or_error)>;
  /// Answered once, at the latest when the deadline is over (10 s; an hour for the result of a goal).
  virtual void call(std::uint32_t service, std::span<const std::uint8_t> cdr, Answer answer) = 0;
  virtual void call_json(std::uint32_t service, std::string_view json,
                         Answer answer) = 0;  ///< the reply as JSON text

  using Values = std::function<void(const std::vector<NamedValue>&, const std::vector<std::string>& errors)>;
  /// Named /local_planner.teb.weight_obstacle: the node's full name, a dot, the parameter's. No names: all of
  /// all nodes.
  virtual void get_parameters(const std::vector<std::string>& names, Values values) = 0;
  /// The values that hold afterwards.
  virtual void set_parameters(const std::vector<NamedValue>& parameters, Values values) = 0;

  virtual ConnectionGraph graph() const = 0;
  virtual std::map<std::string, std::string> metadata() const = 0;  ///< ROS_DISTRO among them
};

}  // namespace bw::foxglove
