// The watch over the commands of one process, on the wire. In real time only: lock-step does not hear the
// outside.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "runtime/host/command_watch.hpp"
#include "runtime/ros/node_directory.hpp"

namespace bw {

struct Actor;

/// Marks the local inputs that a node of the graph commands (Input::commander), and gives their topics and
/// those that the graph leaves to others.
std::vector<WatchedTopic> find_watched_topics(const std::vector<Actor*>& all,
                                              const std::vector<Actor*>& local);

/// Not for several threads at once.
class CommandGuard {
 public:
  /// `local`: whose inputs are watched.
  CommandGuard(dds::Participant& participant, const std::vector<WatchedTopic>& topics,
               const std::vector<Actor*>& local)
      : participant_(participant), directory_(participant), watch_(topics), local_(local) {}

  std::vector<CommandWatch::News> look(Time now);
  std::map<std::string, CommandWatch::State> states() const { return watch_.states(); }

 private:
  /// Of the local inputs by topic, in all.
  [[nodiscard]] std::map<std::string, std::uint64_t> count_refused() const;

  dds::Participant& participant_;
  NodeDirectory directory_;
  CommandWatch watch_;
  const std::vector<Actor*>& local_;
  std::map<std::string, std::uint64_t> refused_;  ///< by topic, up to the last look
  std::uint64_t changes_ = 0;
};

}  // namespace bw
