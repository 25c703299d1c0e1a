// One node of ours on ros_discovery_info, so that ROS 2's tools list it with its ends.
#pragma once

#include <memory>
#include <string>

#include "runtime/ros/discovery_info.hpp"

namespace bw {

/// Humble where ROS_DISTRO says so, as ROS 2's own set-up script does.
[[nodiscard]] GidFormat gid_format_of_environment();

class NodeAnnouncement {
 public:
  /// In the root namespace; the participant must outlive this.
  NodeAnnouncement(dds::Participant& participant, const std::string& name);

  void add(const dds::Reader& reader);
  void add(const dds::Writer& writer);
  /// Tells all ends added so far.
  void publish();

 private:
  GidFormat format_;
  ParticipantEntities entities_;
  std::unique_ptr<dds::Writer> writer_;
};

}  // namespace bw
