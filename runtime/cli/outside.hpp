// A look at a running system from outside: discovery, node names, and raw subscriptions by name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/node_directory.hpp"

namespace bw::cli {

class Outside {
 public:
  /// Joins the domain of the environment (ROS_DOMAIN_ID, discovery range).
  Outside();

  /// Waits until discovery has settled: somebody is there, nothing new came for a moment, and `found`, if
  /// given, holds.
  /// On a busy machine others are heard of late; after 3 s nothing is waited for any more.
  void settle(const std::function<bool()>& found = nullptr);
  /// Remote endpoints of ROS topics; with `all` also services and the graph topic.
  std::vector<dds::Endpoint> endpoints(bool all = false) const;
  const std::vector<ParticipantEntities>& nodes();
  /// Full name of the node that owns an endpoint, or "_NODE_NAME_UNKNOWN_".
  std::string node_of(const dds::Guid& endpoint);
  dds::Participant& participant() { return participant_; }

 private:
  dds::Participant participant_;
  NodeDirectory directory_;
};

}  // namespace bw::cli
