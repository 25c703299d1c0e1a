#include "components/robot_base/kobuki/packet_reader.hpp"

#include <algorithm>

namespace bw::kobuki {
namespace {

constexpr std::uint8_t kFirst = 0xAA, kSecond = 0x55;
constexpr std::size_t kFrame = 4;  ///< bytes of a packet that are not payload
constexpr std::uint8_t kCoreId = 0x01, kCoreSize = 15;

enum class Candidate { refused, incomplete, bad_checksum, sound };

struct Judgement {
  Candidate candidate = Candidate::refused;
  std::size_t size = 0;  ///< of the whole packet
  bool has_core = false;
};

/// Refused as soon as what is there cannot become a packet.
Judgement judge(std::span<const std::uint8_t> bytes) {
  if (bytes[0] != kFirst) return {};
  if (bytes.size() < 2) return {Candidate::incomplete};
  if (bytes[1] != kSecond) return {};
  if (bytes.size() < 3) return {Candidate::incomplete};
  const std::size_t length = bytes[2];
  if (length < 2) return {};
  const std::size_t end = 3 + length;
  bool has_core = false;
  std::size_t at = 3;
  while (at < end) {
    if (at + 1 >= end) return {};
    if (at + 1 >= bytes.size()) return {Candidate::incomplete};
    const std::size_t after = at + 2 + bytes[at + 1];
    if (after > end) return {};
    has_core |= bytes[at] == kCoreId && bytes[at + 1] == kCoreSize;
    at = after;
  }
  if (bytes.size() <= end) return {Candidate::incomplete};
  std::uint8_t sum = 0;
  for (const std::uint8_t byte : bytes.subspan(2, length + 1)) sum = static_cast<std::uint8_t>(sum ^ byte);
  return {sum == bytes[end] ? Candidate::sound : Candidate::bad_checksum, length + kFrame, has_core};
}

}  // namespace

void PacketReader::add(std::span<const std::uint8_t> bytes) {
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(taken_));
  taken_ = 0;
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void PacketReader::reset() {
  bytes_.clear();
  taken_ = 0;
}

void PacketReader::drop(std::size_t bytes) {
  taken_ += bytes;
  counts_.bytes_thrown_away += bytes;
}

std::span<const std::uint8_t> PacketReader::next() {
  const std::span<const std::uint8_t> all(bytes_);
  while (taken_ < all.size()) {
    const std::span<const std::uint8_t> rest = all.subspan(taken_);
    const Judgement first = judge(rest);
    if (first.candidate == Candidate::refused || first.candidate == Candidate::bad_checksum) {
      if (first.candidate == Candidate::bad_checksum) ++counts_.bad_checksums;
      drop(1);
      continue;
    }
    const bool is_whole = first.candidate == Candidate::sound;
    const std::size_t last = is_whole ? first.size : rest.size();
    std::size_t begin = 0;
    std::size_t size = is_whole ? first.size : 0;
    // One within it that ends earlier.
    for (std::size_t at = 1; at < last; ++at) {
      if (rest[at] != kFirst) continue;
      const Judgement later = judge(rest.subspan(at));
      if (later.candidate != Candidate::sound || !later.has_core) continue;
      if (size != 0 && at + later.size >= begin + size) continue;
      begin = at;
      size = later.size;
    }
    if (size == 0) return {};
    drop(begin);
    taken_ += size;
    ++counts_.packets;
    return rest.subspan(begin + 3, size - kFrame);
  }
  return {};
}

}  // namespace bw::kobuki
