// One call of a ROS 2 service that waits for its reply: for programs of the command line. Components have
// Setup::client, which does not wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/service.hpp"

namespace bw {

/// The reply's bytes; nothing when no server answered within `limit`.
std::optional<std::vector<std::uint8_t>> call_service(dds::Participant& participant, const std::string& name,
                                                      const ServiceType& type,
                                                      std::span<const std::uint8_t> request,
                                                      std::chrono::milliseconds limit);

template <class S>
std::optional<typename S::Response> call_service(dds::Participant& participant, const std::string& name,
                                                 const typename S::Request& request,
                                                 std::chrono::milliseconds limit) {
  std::vector<std::uint8_t> cdr;
  serialize(request, cdr);
  const auto reply = call_service(participant, name, service_type<S>(), cdr, limit);
  typename S::Response response;
  if (!reply || !deserialize(*reply, response)) return std::nullopt;
  return response;
}

}  // namespace bw
