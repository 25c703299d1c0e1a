// A look at a running system from outside: discovery, node names, and raw subscriptions by name.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/ros/discovery_info.hpp"

namespace bw::cli {

class Outside {
 public:
  /// Joins the domain of the environment (ROS_DOMAIN_ID, discovery range).
  Outside();

  /// Waits until discovery has settled: nothing new for a moment, at most `limit`.
  void settle(std::chrono::milliseconds limit = std::chrono::milliseconds(3000));
  /// Remote endpoints of ROS topics; with `all` also services and the graph topic.
  std::vector<dds::Endpoint> endpoints(bool all = false) const;
  std::vector<ParticipantEntities> nodes();
  /// Full name of the node that owns an endpoint, or "_NODE_NAME_UNKNOWN_".
  std::string node_of(const dds::Guid& endpoint);
  dds::Participant& participant() { return participant_; }

 private:
  dds::Participant participant_;
  std::unique_ptr<dds::Reader> node_reader_;
  std::vector<ParticipantEntities> nodes_;
};

/// nav_msgs::msg::dds_::Odometry_ -> nav_msgs/msg/Odometry; other names unchanged.
std::string ros_type(const std::string& dds_type);
/// rt/odom -> /odom.
std::string ros_topic(const std::string& dds_topic);

}  // namespace bw::cli
