// Packets of a Kobuki put together for tests, by the table of the protocol and not by the code that is
// tested.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "tests/components/robot_base/scripted_link.hpp"

namespace bw::kobuki {

inline Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

inline Bytes packet(const Bytes& payload) {
  Bytes bytes = joined({{0xAA, 0x55, static_cast<std::uint8_t>(payload.size())}, payload});
  std::uint8_t sum = 0;
  for (std::size_t i = 2; i < bytes.size(); ++i) sum = static_cast<std::uint8_t>(sum ^ bytes[i]);
  bytes.push_back(sum);
  return bytes;
}

/// What the tests vary of a core payload.
struct Said {
  int stamp = 0, left = 0, right = 0;
  std::uint8_t bumper = 0, drop = 0, cliff = 0, buttons = 0, charger = 0, battery = 160, overcurrent = 0;
};

inline Bytes core_payload(const Said& said) {
  const auto low = [](int value) { return static_cast<std::uint8_t>(value & 0xFF); };
  const auto high = [](int value) { return static_cast<std::uint8_t>(value >> 8 & 0xFF); };
  return {0x01,
          15,
          low(said.stamp),
          high(said.stamp),
          said.bumper,
          said.drop,
          said.cliff,
          low(said.left),
          high(said.left),
          low(said.right),
          high(said.right),
          0,
          0,
          said.buttons,
          said.charger,
          said.battery,
          said.overcurrent};
}

inline Bytes inertia_payload(int centidegrees, int rate) {
  return {0x04,
          7,
          static_cast<std::uint8_t>(centidegrees & 0xFF),
          static_cast<std::uint8_t>(centidegrees >> 8 & 0xFF),
          static_cast<std::uint8_t>(rate & 0xFF),
          static_cast<std::uint8_t>(rate >> 8 & 0xFF),
          0,
          0,
          0};
}

/// As a base sends it every 20 ms: core, dock, inertia, cliff, current, raw gyro with two samples, inputs.
inline Bytes whole_packet(const Said& said) {
  return packet(joined({core_payload(said),
                        {0x03, 3, 0, 0, 0},
                        inertia_payload(0, 0),
                        {0x05, 6, 1, 2, 3, 4, 5, 6},
                        {0x06, 2, 10, 12},
                        {0x0D, 14, 7, 6, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0},
                        {0x10, 16, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}}));
}

}  // namespace bw::kobuki
