// What tests of services and actions look at on the wire.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/interop/plain/node.hpp"

namespace bw::test {

/// PID_RELATED_SAMPLE_IDENTITY as eProsima and RTI number it: GUID, then the sequence number, high word
/// first.
inline constexpr std::uint16_t kRelatedIdentity = 0x800f;

inline std::string wire_hex(const std::string& hex) {
  return plain::to_hex(plain::padded(plain::from_hex(hex)));
}

inline plain::Bytes identity_bytes(const plain::Gid& gid, std::uint32_t high, std::uint32_t low) {
  plain::Bytes bytes(gid.begin(), gid.end());
  for (const std::uint32_t word : {high, low}) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  }
  return bytes;
}

/// The end of a topic that is not ours; there must be one alone.
inline std::pair<plain::Gid, plain::End> foreign_end(const plain::Node& node, const std::string& topic,
                                                     bool is_writer) {
  std::vector<std::pair<plain::Gid, plain::End>> found;
  for (const auto& [gid, end] : node.ends()) {
    if (!end.is_own && end.topic == topic && end.is_writer == is_writer) found.emplace_back(gid, end);
  }
  if (found.size() != 1) throw std::runtime_error(std::to_string(found.size()) + " ends of " + topic);
  return found.front();
}

}  // namespace bw::test
