#include "components/robot_base/kobuki/feedback.hpp"

#include <cstddef>

namespace bw::kobuki {
namespace {

using Data = std::span<const std::uint8_t>;

std::uint16_t u16(Data data, std::size_t at) {
  return static_cast<std::uint16_t>(data[at] | data[at + 1] << 8);
}
std::int16_t i16(Data data, std::size_t at) { return static_cast<std::int16_t>(u16(data, at)); }
std::uint32_t u32(Data data, std::size_t at) {
  return u16(data, at) | static_cast<std::uint32_t>(u16(data, at + 2)) << 16;
}

Core core(Data d) {
  return {.stamp = u16(d, 0),
          .bumper = d[2],
          .wheel_drop = d[3],
          .cliff = d[4],
          .left_encoder = u16(d, 5),
          .right_encoder = u16(d, 7),
          .left_pwm = static_cast<std::int8_t>(d[9]),
          .right_pwm = static_cast<std::int8_t>(d[10]),
          .buttons = d[11],
          .charger = d[12],
          .battery = d[13],
          .overcurrent = d[14]};
}

RawGyro raw_gyro(Data d) {
  RawGyro gyro{.frame = d[0], .samples = {}};
  for (std::size_t at = 2; at + 6 <= d.size(); at += 6)
    gyro.samples.push_back({i16(d, at), i16(d, at + 2), i16(d, at + 4)});
  return gyro;
}

Inputs inputs(Data d) {
  return {.digital = u16(d, 0), .analog = {u16(d, 2), u16(d, 4), u16(d, 6), u16(d, 8)}};
}

/// Old boards tell two bytes.
Version version(Data d) {
  return {.patch = d[0], .minor = d[1], .major = d.size() > 2 ? d[2] : std::uint8_t{0}};
}

/// False when it is not known, or not of its size.
bool take(Feedback& to, std::uint8_t id, Data d) {
  const auto has = [&](std::size_t size) { return d.size() == size; };
  if (id == 0x01 && has(15)) {
    to.core = core(d);
  } else if (id == 0x03 && has(3)) {
    to.dock = {d[0], d[1], d[2]};
  } else if (id == 0x04 && has(7)) {
    to.inertia = {i16(d, 0), i16(d, 2)};
  } else if (id == 0x05 && has(6)) {
    to.cliff = {u16(d, 0), u16(d, 2), u16(d, 4)};
  } else if (id == 0x06 && has(2)) {
    to.currents = {d[0], d[1]};
  } else if (id == 0x0A && (has(4) || has(2))) {
    to.hardware = version(d);
  } else if (id == 0x0B && (has(4) || has(2))) {
    to.firmware = version(d);
  } else if (id == 0x0D && d.size() >= 2 && d[1] % 3 == 0 && has(2 + std::size_t{2} * d[1])) {
    to.gyro = raw_gyro(d);
  } else if (id == 0x10 && has(16)) {
    to.inputs = inputs(d);
  } else if (id == 0x13 && has(12)) {
    to.id = {u32(d, 0), u32(d, 4), u32(d, 8)};
  } else if (id == 0x15 && has(13)) {
    to.controller = {.is_user = d[0] != 0, .p = u32(d, 1), .i = u32(d, 5), .d = u32(d, 9)};
  } else {
    return false;
  }
  return true;
}

}  // namespace

Feedback parse(std::span<const std::uint8_t> payload) {
  Feedback feedback;
  while (payload.size() >= 2 && payload.size() >= std::size_t{2} + payload[1]) {
    if (!take(feedback, payload[0], payload.subspan(2, payload[1]))) ++feedback.skipped;
    payload = payload.subspan(std::size_t{2} + payload[1]);
  }
  return feedback;
}

}  // namespace bw::kobuki
