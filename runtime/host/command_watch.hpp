// Who writes in vain on topics that this process hears. A command has one owner in the graph and is read in a
// partition of this owner, where nobody else writes: the others are not heard, and named here. So are those
// who write another type on a topic that the graph leaves to others.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/logger.hpp"

namespace bw {

/// A topic that commands something, and whose it is; or one that the graph leaves to others.
struct WatchedTopic {
  std::string topic;                   ///< /cmd_vel
  std::string type;                    ///< geometry_msgs/msg/Twist
  std::string owner = {};              ///< full name of the node, /collision_monitor; empty: anybody's
  std::vector<std::string> open = {};  ///< others of the same type that are anybody's
};

/// The DDS partition in which commands of this node are read. All processes of a graph derive the same.
std::string command_partition(const std::string& owner);

/// Endpoints in, news out: no DDS, no clock.
class CommandWatch {
 public:
  struct News {
    LogLevel level = LogLevel::warn;
    std::string text;
  };
  /// What is known of one topic, for the diagnostics.
  struct State {
    LogLevel level = LogLevel::info;  ///< warn: somebody is refused; error: two owners command
    std::string text;
  };
  /// Whether commands of its owner were refused on a topic since the last call, because another owner commands too.
  using Refuses = std::function<bool(const std::string& topic)>;
  using NodeOf = std::function<std::string(const dds::Guid&)>;  ///< empty: not named yet

  explicit CommandWatch(const std::vector<WatchedTopic>& topics);

  /// To be called every half second or so, with the endpoints that are there and the writers that left since
  /// the last call.
  /// A writer is told once: when its node has a name, or after a second without one. Two owners are told when commands have
  /// been refused for two seconds: one that was killed counts as there for longer, and who takes its place is obeyed meanwhile.
  std::vector<News> look(const std::vector<dds::Endpoint>& present,
                         const std::vector<dds::Endpoint>& departed, const NodeOf& node_of, Time now,
                         const Refuses& refuses = {});
  /// By topic.
  std::map<std::string, State> states() const;
  /// A writer waits for its name, or commands are refused: look again although nothing has changed.
  bool is_waiting() const;

 private:
  struct UnknownDevice {
    Time since;
    std::string type;
    std::string name = {};  ///< empty: not known yet
    bool is_told = false;
    bool is_there = true;
  };
  struct Watched {
    WatchedTopic topic;
    std::map<dds::Guid, UnknownDevice> strangers;
    int owners = 0;
    std::optional<Time> refused_since;
    bool is_refused = false;  ///< for so long that it is told
  };

  static std::optional<News> news_of_owners(Watched& watched, bool refuses, Time now);
  static std::vector<std::string> names_to_tell(Watched& watched, const NodeOf& node_of, Time now);
  static std::string label(const Watched& watched, const UnknownDevice& stranger);
  static std::string refusal(const WatchedTopic& topic, const std::vector<std::string>& names);

  std::vector<Watched> watched_;
};

}  // namespace bw
