// The topic by which ROS 2 tools learn which nodes a process holds:
// rmw_dds_common/msg/ParticipantEntitiesInfo on ros_discovery_info. Its gid is 24 bytes in Humble and 16 from
// Iron on, under one type name; both are written and read here.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"

namespace bw {

inline constexpr const char* kDiscoveryTopic = "ros_discovery_info";
inline constexpr const char* kDiscoveryType = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
inline constexpr const char* kDiscoveryTypeHash =
    "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e";

enum class GidFormat { humble, iron_and_later };

struct NodeEntities {
  std::string node_namespace;  ///< "/" or "/robot1"
  std::string name;
  std::vector<dds::Guid> readers;
  std::vector<dds::Guid> writers;
};

struct ParticipantEntities {
  dds::Guid participant{};
  std::vector<NodeEntities> nodes;
};

std::vector<std::uint8_t> encode(const ParticipantEntities& entities, GidFormat format);

/// Tries both formats and takes the one that consumes the bytes; nothing when neither does. Never allocates
/// beyond the input's size.
std::optional<ParticipantEntities> decode_participant_entities(std::span<const std::uint8_t> cdr);

}  // namespace bw
