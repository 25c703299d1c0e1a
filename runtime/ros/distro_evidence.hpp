// Which distributions the others on a domain run, by what their endpoints say. Endpoints in, verdict out.
//
// From Iron on an endpoint's user data tells the hash of its type; on ros_discovery_info, which every ROS 2
// process has, a hash means Iron or later, a writer without means Humble; who only reads there may be any
// program. Our own endpoints there that read both formats, or have not decided, say so and count for nothing.
// A participant that has no end on ros_discovery_info counts by its other endpoints, for what they have:
// without a hash they may belong to anybody.
#pragma once

#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"

namespace bw {

/// User data of an end on ros_discovery_info that reads both formats.
[[nodiscard]] std::string discovery_reader_user_data();

struct DistroEvidence {
  bool humble = false;
  bool iron_and_later = false;
  bool operator==(const DistroEvidence&) const = default;
};

[[nodiscard]] DistroEvidence distro_evidence(const std::vector<dds::Endpoint>& endpoints);

}  // namespace bw
