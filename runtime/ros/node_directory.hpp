// Which node owns an endpoint: what all participants of the domain say on ros_discovery_info.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/ros/discovery_info.hpp"

namespace bw {

/// Not for several threads at once.
class NodeDirectory {
 public:
  /// The participant must outlive this. `on_news` runs on a DDS thread when there is something to read: it
  /// may only enqueue.
  explicit NodeDirectory(
      dds::Participant& participant, std::function<void()> on_news = [] {});

  /// Reads what came; true when something did.
  bool update();
  /// Participants that have left, and the names of ends that are gone.
  void forget_the_gone();
  [[nodiscard]] const std::vector<ParticipantEntities>& participants() const { return participants_; }
  /// Its full name, /robot1/base; empty when nobody has named the endpoint.
  [[nodiscard]] std::string node_of(const dds::Guid& endpoint) const;

 private:
  void add_names(const ParticipantEntities& participant);

  dds::Participant& participant_;
  std::unique_ptr<dds::Reader> reader_;
  std::vector<ParticipantEntities> participants_;
  std::map<dds::Guid, std::string> node_of_;
};

/// /robot1/base
[[nodiscard]] std::string full_name(const NodeEntities& node);

}  // namespace bw
