// What the server sends: JSON texts and little-endian binary messages.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/remote/foxglove/graph_difference.hpp"
#include "runtime/remote/foxglove/protocol.hpp"
#include "runtime/remote/foxglove/robot.hpp"

namespace bw::foxglove {

struct ServerInfo {
  std::string name;
  std::vector<std::string> capabilities;
  std::map<std::string, std::string> metadata;
  std::string session;  ///< another one after a restart; empty: not told
};
/// Both encodings are offered, cdr first: Foxglove and Lichtblick take the first.
std::string server_info_op(const ServerInfo& info);

/// A newer status with the same id takes the older's place; an empty id is none.
std::string status_op(Level level, const std::string& message, const std::string& id = "");
std::string remove_status_op(const std::vector<std::string>& ids);

/// Channels of CDR with ros2msg schemas; a latched one has metadata {latched: "true"}.
std::string advertise_op(std::span<const Channel> channels);
std::string unadvertise_op(const std::vector<std::uint32_t>& channels);
std::string advertise_services_op(std::span<const Service> services);
std::string unadvertise_services_op(const std::vector<std::uint32_t>& services);

std::string parameter_values_op(const std::vector<NamedValue>& parameters,
                                const std::optional<std::string>& request);
std::string graph_update_op(const GraphDifference& difference);
std::string service_failure_op(std::uint32_t service, std::uint32_t call, const std::string& message);

/// Opcode 1: u32 subscription, u64 time [ns]; the payload follows. Times before 1970 are 0.
std::array<std::uint8_t, 13> message_head(std::uint32_t subscription, Time time);
/// Opcode 2: u64 time [ns].
Bytes time_bytes(Time time);
/// Opcode 3: u32 service, u32 call, u32 length, encoding, payload.
Bytes service_response_bytes(std::uint32_t service, std::uint32_t call, std::string_view encoding,
                             std::span<const std::uint8_t> payload);
/// Opcode 4: u32 request, u8 status (0 ok, 1 error), u32 length, error, data.
Bytes asset_bytes(std::uint32_t request, std::span<const std::uint8_t> data);
Bytes asset_error_bytes(std::uint32_t request, std::string_view error);

}  // namespace bw::foxglove
