// Our nodes on ros_discovery_info, so that ROS 2's tools list them with their ends.
//
// In which format is decided once: by the caller, by ROS_DISTRO, or within two seconds by what the others on
// the domain announce (distro_evidence.hpp); where nobody is, as for Jazzy. Nothing waits for that but the
// list of nodes. Who comes later with the other format is told of, and changes nothing.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "runtime/base/ros_distro.hpp"
#include "runtime/ros/discovery_info.hpp"
#include "runtime/ros/distro_evidence.hpp"
#include "runtime/thrown.hpp"

namespace bw {

struct AnnouncementOptions {
  RosDistro distro = RosDistro::automatic;
  bool looks_around = true;  ///< false: decides at once and hears nobody, as lock-step must
  /// Is told of the other format on the domain, once, on a thread of the announcement's own. Empty: nobody is
  /// looked for after the decision.
  std::function<void(const std::string&)> warn = nullptr;
};

class NodeAnnouncement {
 public:
  static constexpr Duration kPatience = Duration::milliseconds(2000);

  /// The participant must outlive this.
  NodeAnnouncement(dds::Participant& participant, AnnouncementOptions options);
  /// One node in the root namespace, of a tool that may be gone in a moment: it decides at once.
  NodeAnnouncement(dds::Participant& participant, const std::string& name,
                   RosDistro distro = RosDistro::automatic);
  ~NodeAnnouncement();
  NodeAnnouncement(const NodeAnnouncement&) = delete;
  NodeAnnouncement& operator=(const NodeAnnouncement&) = delete;

  void add(NodeEntities node);
  /// Ends of the last node.
  void add(const dds::Reader& reader);
  void add(const dds::Writer& writer);
  /// Ends of the last node that are about to go.
  void remove(const dds::Reader& reader);
  void remove(const dds::Writer& writer);
  /// Tells all nodes and ends there are, once the format is decided.
  void publish();

  /// Nothing until it is decided.
  [[nodiscard]] std::optional<RosDistro> distro() const;
  /// Throws what ended the announcement's own thread, once.
  void rethrow() { failure_.rethrow(); }

 private:
  void look_around();
  void decide(RosDistro distro);
  void write();
  void warn_of_contradiction(const DistroEvidence& evidence);
  [[nodiscard]] bool is_told_everything() const { return decided_ && !options_.warn; }

  dds::Participant& participant_;
  AnnouncementOptions options_;
  Duration began_;  ///< on the monotonic clock
  std::uint64_t seen_changes_ = 0;
  DistroEvidence evidence_;
  bool told_contradiction_ = false;

  mutable std::mutex mutex_;  ///< guards what follows
  std::optional<RosDistro> decided_;
  bool is_published_ = false;
  ParticipantEntities entities_;
  std::unique_ptr<dds::Writer> writer_;
  bool stop_ = false;
  std::condition_variable wake_;
  KeptException failure_;
  std::thread thread_;
};

}  // namespace bw
