#include "runtime/ros/distro_evidence.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/discovery_info.hpp"

namespace bw {
namespace {

constexpr const char* kReadsBoth = "gid=any;";
using Prefix = std::array<std::uint8_t, 12>;

/// What the endpoints of one participant say.
struct Participant {
  bool has_discovery_info = false;
  DistroEvidence by_discovery_info;
  bool has_hashes = false;  ///< on topics and services
};

bool is_ros_name(const std::string& topic) {
  return topic.starts_with("rt/") || topic.starts_with("rq/") || topic.starts_with("rr/");
}

}  // namespace

std::string discovery_reader_user_data() { return user_data_of(kDiscoveryTypeHash) + kReadsBoth; }

DistroEvidence distro_evidence(const std::vector<dds::Endpoint>& endpoints) {
  std::map<Prefix, Participant> participants;
  for (const dds::Endpoint& endpoint : endpoints) {
    if (endpoint.is_local) continue;
    Prefix prefix{};
    std::copy_n(endpoint.guid.begin(), prefix.size(), prefix.begin());
    Participant& participant = participants[prefix];
    const bool has_hash = !type_hash_in(endpoint.user_data).empty();
    if (endpoint.topic != kDiscoveryTopic) {
      participant.has_hashes |= has_hash && is_ros_name(endpoint.topic);
      continue;
    }
    if (!has_hash && !endpoint.is_writer) continue;
    participant.has_discovery_info = true;
    if (endpoint.user_data.find(kReadsBoth) != std::string::npos) continue;
    (has_hash ? participant.by_discovery_info.iron_and_later : participant.by_discovery_info.humble) = true;
  }
  DistroEvidence all;
  for (const auto& [prefix, participant] : participants) {
    all.humble |= participant.by_discovery_info.humble;
    all.iron_and_later |= participant.by_discovery_info.iron_and_later ||
                          (!participant.has_discovery_info && participant.has_hashes);
  }
  return all;
}

}  // namespace bw
