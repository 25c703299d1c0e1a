#include "components/emulators/kobuki/host_packets.hpp"

#include <cstddef>

namespace bw::emulators {
namespace {

constexpr std::uint8_t kFirst = 0xAA;
constexpr std::uint8_t kSecond = 0x55;
constexpr std::size_t kAround = 4;  // two bytes before, the length, the checksum

void split(std::span<const std::uint8_t> payload, const HostPackets::OnCommand& on_command) {
  while (payload.size() >= 2) {
    const std::size_t size = payload[1];
    if (payload.size() < 2 + size) return;
    on_command(payload[0], payload.subspan(2, size));
    payload = payload.subspan(2 + size);
  }
}

}  // namespace

void HostPackets::receive(std::span<const std::uint8_t> bytes, const OnCommand& on_command) {
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  while (const std::size_t done = take(on_command))
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(done));
}

std::size_t HostPackets::take(const OnCommand& on_command) {
  if (waiting_.empty()) return 0;
  if (waiting_[0] != kFirst) return 1;
  if (waiting_.size() < 2) return 0;
  if (waiting_[1] != kSecond) return 1;
  if (waiting_.size() < 3) return 0;
  const std::size_t length = waiting_[2];
  if (waiting_.size() < length + kAround) return 0;
  std::uint8_t sum = 0;
  for (std::size_t i = 2; i < 3 + length; ++i) sum ^= waiting_[i];
  // A wrong one may have been a piece of something else, with a packet inside.
  if (sum != waiting_[3 + length]) return 2;
  split(std::span(waiting_).subspan(3, length), on_command);
  return length + kAround;
}

}  // namespace bw::emulators
