// Who else on the domain has the name of one of our nodes, or serves what one of them serves. ROS 2 lets both
// answer: a manager brings up either, a client hears whoever is first. Endpoints and nodes in, words out: no
// DDS, no clock.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/logger.hpp"
#include "runtime/ros/discovery_info.hpp"

namespace bw {

/// A node of this process.
struct OwnNode {
  std::string name;                   ///< full, /planner_server
  std::vector<std::string> services;  ///< absolute; those of actions too
};

/// What is on the domain at one moment.
struct DomainView {
  dds::Guid own_participant{};
  const std::vector<ParticipantEntities>& participants;
  const std::vector<dds::Endpoint>& endpoints;
  std::function<std::string(const dds::Guid&)> node_of;  ///< of an endpoint; empty: not named yet
};

class DuplicateNameWatch {
 public:
  struct News {
    LogLevel level = LogLevel::error;
    std::string text;
  };

  explicit DuplicateNameWatch(std::vector<OwnNode> nodes) : nodes_(std::move(nodes)) {}

  /// To be called every half second or so. Who is there is told at the second look: names and servers of a
  /// process come one after the other. Who has left is told too.
  std::vector<News> look(const DomainView& view);
  /// Whom `view` shows beside our node of this full name; empty: nobody.
  std::string rivals_of(const std::string& node, const DomainView& view) const;
  /// What there is to say now of each node that ever had a rival, by its name.
  const std::map<std::string, News>& states() const { return states_; }
  /// Somebody is seen and not told yet: look again although nothing has changed.
  bool is_waiting() const;

 private:
  struct Rival {
    std::string node;                   ///< empty: nobody has named it yet
    bool is_duplicate = false;          ///< its name is that of ours
    std::vector<std::string> services;  ///< that ours has too; actions by their own name
    int looks = 0;
  };
  /// By our node and the prefix of the other's participant.
  using Rivals = std::map<std::pair<const OwnNode*, dds::Guid>, Rival>;

  Rivals rivals_in(const DomainView& view) const;
  static std::string sentence(const OwnNode& ours, const dds::Guid& theirs, const Rival& rival,
                              const dds::Guid& own_participant);
  static News news_of(std::string text);

  std::vector<OwnNode> nodes_;
  Rivals rivals_;
  std::map<std::pair<const OwnNode*, dds::Guid>, std::string> told_;
  std::map<std::string, News> states_;
};

}  // namespace bw
