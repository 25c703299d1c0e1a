// How the two topics of a service are opened, for servers and clients alike.
#pragma once

#include <string>

#include "runtime/dds/participant.hpp"
#include "runtime/ports.hpp"
#include "runtime/ros/dds_names.hpp"

namespace bw {

/// As rmw has services and parameters, with the longer history of the two: it outlasts a busy lane. Few
/// samples wait, and there are many such ends.
inline dds::EndpointOptions service_end(const std::string& dds_topic, const MessageType& type) {
  constexpr int kDepth = 1000;
  return {.topic = dds_topic,
          .type = std::string(type.dds_name),
          .qos = Qos::standard(kDepth),
          .user_data = user_data_of(std::string(type.type_hash)),
          .heartbeat = dds::kPromptHeartbeat,
          .allocated_samples = 1};
}

}  // namespace bw
