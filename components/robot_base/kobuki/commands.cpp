#include "components/robot_base/kobuki/commands.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>

namespace bw::kobuki {
namespace {

constexpr std::uint8_t low(int value) { return static_cast<std::uint8_t>(value & 0xFF); }
constexpr std::uint8_t high(int value) { return static_cast<std::uint8_t>(value >> 8 & 0xFF); }

/// Cut to a whole number; one that rounding left a hair below itself counts as itself.
std::int16_t limited(double value) {
  using Limits = std::numeric_limits<std::int16_t>;
  const double whole = std::trunc(value + std::copysign(1e-6, value));
  return static_cast<std::int16_t>(std::clamp(whole, double{Limits::min()}, double{Limits::max()}));
}

/// Of one sub-payload.
Bytes packet(std::uint8_t id, std::initializer_list<std::uint8_t> data) {
  const auto size = static_cast<std::uint8_t>(data.size());
  Bytes bytes;
  bytes.reserve(data.size() + 6);
  for (const std::uint8_t byte :
       {std::uint8_t{0xAA}, std::uint8_t{0x55}, static_cast<std::uint8_t>(size + 2), id, size})
    bytes.push_back(byte);
  for (const std::uint8_t byte : data) bytes.push_back(byte);
  std::uint8_t sum = 0;
  for (std::size_t at = 2; at < bytes.size(); ++at) sum = static_cast<std::uint8_t>(sum ^ bytes[at]);
  bytes.push_back(sum);
  return bytes;
}

}  // namespace

SpeedAndRadius speed_and_radius(const WheelSpeeds& wheels, double separation) {
  constexpr double kNothing = 1e-4;
  const Twist2 twist = to_twist(wheels, separation);
  if (!std::isfinite(twist.v) || !std::isfinite(twist.omega)) return {};
  const double half = 1000.0 * separation / 2.0;
  if (std::abs(twist.omega) < kNothing) return {limited(1000.0 * twist.v), 0};
  const double radius = 1000.0 * twist.v / twist.omega;
  if (std::abs(twist.v) < kNothing || std::abs(radius) <= 1.0) return {limited(half * twist.omega), 1};
  const double outer = radius > 0.0 ? radius + half : radius - half;
  return {limited(outer * twist.omega), limited(radius)};
}

Bytes base_control(const SpeedAndRadius& motion) {
  return packet(0x01, {low(motion.speed), high(motion.speed), low(motion.radius), high(motion.radius)});
}

Bytes request_versions() { return packet(0x09, {0x01 | 0x02 | 0x08, 0x00}); }

Bytes set_user_gains(const Gains& gains) {
  const auto byte = [](double gain, int index) {
    return static_cast<std::uint8_t>(static_cast<std::uint32_t>(std::lround(gain * 1000.0)) >> 8 * index);
  };
  const auto [p, i, d] = gains;
  return packet(0x0D, {1, byte(p, 0), byte(p, 1), byte(p, 2), byte(p, 3), byte(i, 0), byte(i, 1), byte(i, 2),
                       byte(i, 3), byte(d, 0), byte(d, 1), byte(d, 2), byte(d, 3)});
}

Bytes request_gains() { return packet(0x0E, {0}); }

}  // namespace bw::kobuki
