// A packet that a Kobuki sends, put together from sub-payloads; little endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bw::emulators {

class BasePacket {
 public:
  /// Begins a sub-payload; what is put after it belongs to it.
  BasePacket& begin(std::uint8_t id) {
    bytes_.push_back(id);
    bytes_.push_back(0);
    size_at_ = bytes_.size() - 1;
    return *this;
  }
  BasePacket& u8(unsigned value) {
    bytes_.push_back(static_cast<std::uint8_t>(value));
    ++bytes_[size_at_];
    return *this;
  }
  BasePacket& u16(unsigned value) { return u8(value & 0xFFU).u8((value >> 8U) & 0xFFU); }
  BasePacket& i16(int value) { return u16(static_cast<unsigned>(value) & 0xFFFFU); }
  BasePacket& u32(std::uint32_t value) { return u16(value & 0xFFFFU).u16(value >> 16U); }

  /// Framed, behind what `out` holds.
  void append_to(std::vector<std::uint8_t>& out) const {
    const auto length = static_cast<std::uint8_t>(bytes_.size());
    std::uint8_t sum = length;
    for (const std::uint8_t byte : bytes_) sum ^= byte;
    out.insert(out.end(), {0xAA, 0x55, length});
    out.insert(out.end(), bytes_.begin(), bytes_.end());
    out.push_back(sum);
  }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t size_at_ = 0;
};

}  // namespace bw::emulators
