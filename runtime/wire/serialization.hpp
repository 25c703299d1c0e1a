// Messages to and from the bytes of ROS 2 (XCDR1 plain CDR with its 4-byte encapsulation). Include the header
// of the message, for example "nav_msgs/msg/odometry.hpp": it brings the class, its traits and these
// functions, and no DDS.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/wire/type_description.hpp"

namespace bw {

/// Specialised by the build for every IDL struct:
///   static constexpr std::string_view ros_name, dds_name, type_hash;
///   static const TypeDescription& description();
///   static void serialize(const M&, std::vector<std::uint8_t>&);
///   static bool deserialize(std::span<const std::uint8_t>, M&, std::string*);
template <class M>
struct MessageTraits;

/// Replaces `bytes` by the little-endian CDR of `message`. Padding is zero, so equal messages give equal
/// bytes.
template <class M>
void serialize(const M& message, std::vector<std::uint8_t>& bytes) {
  MessageTraits<M>::serialize(message, bytes);
}

/// Bytes from anywhere, hostile ones included: checks them first (runtime/wire/validate.hpp), never throws.
/// Returns false, with the reason if asked, when they are not an M; `message` is then unspecified but usable.
template <class M>
[[nodiscard]] bool deserialize(std::span<const std::uint8_t> bytes, M& message,
                               std::string* reason = nullptr) {
  return MessageTraits<M>::deserialize(bytes, message, reason);
}

}  // namespace bw
