// Packets that a host sends to a Kobuki: framing, checksum and sub-payloads of the protocol's page on
// commands.
//
//   AA 55 | length of the payload | payload: (id, size, data)... | XOR of length and payload
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace bw::emulators {

class HostPackets {
 public:
  using OnCommand = std::function<void(std::uint8_t id, std::span<const std::uint8_t> data)>;

  /// Calls for each sub-payload of each whole packet with a good checksum. What is no packet is passed over.
  void receive(std::span<const std::uint8_t> bytes, const OnCommand& on_command);

 private:
  /// Bytes at the front that are done with; 0: more are needed.
  std::size_t take(const OnCommand& on_command);

  std::vector<std::uint8_t> waiting_;
};

}  // namespace bw::emulators
