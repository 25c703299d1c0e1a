#include "components/emulators/kobuki/kobuki_firmware.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bw::emulators {
namespace {

constexpr int kPeriod = 20;                        // [ms] between packets
constexpr double kElectronics = 0.4;               // [A] drawn without motors
constexpr double kChargingCurrent = -1.2;          // [A]
constexpr unsigned kFloor = 1700, kNoFloor = 250;  // cliff sensors, in steps of their converter
constexpr unsigned kHardware = 1, kFirmware = 2, kUdid = 8;
constexpr std::array<unsigned, 3> kHardwareVersion = {4, 0, 1};  // patch, minor, major
constexpr std::array<unsigned, 3> kFirmwareVersion = {0, 2, 1};
constexpr std::array<std::uint32_t, 3> kUdidWords = {0x30393235, 0x32345719, 0x43189416};

unsigned bits(bool first, bool second, bool third = false) {
  return (first ? 1U : 0U) | (second ? 2U : 0U) | (third ? 4U : 0U);
}

unsigned u16_at(std::span<const std::uint8_t> data, std::size_t at) {
  return static_cast<unsigned>(data[at]) | static_cast<unsigned>(data[at + 1]) << 8U;
}

std::uint32_t u32_at(std::span<const std::uint8_t> data, std::size_t at) {
  return u16_at(data, at) | u16_at(data, at + 2) << 16U;
}

int i16_at(std::span<const std::uint8_t> data, std::size_t at) {
  return static_cast<std::int16_t>(u16_at(data, at));
}

/// Duty of a motor as the packet tells it; it goes with the speed.
unsigned pwm(double speed) {
  const auto duty = static_cast<int>(std::lround(std::clamp(speed / 0.7, -1.0, 1.0) * 100.0));
  return static_cast<unsigned>(duty) & 0xFFU;
}

unsigned in_ten_milliamperes(double current) {
  return static_cast<unsigned>(std::clamp(std::lround(current * 100.0), 0L, 255L));
}

}  // namespace

KobukiFirmware::KobukiFirmware(const KobukiOptions& options, const Robot& robot, std::uint64_t seed)
    : options_(options),
      separation_(robot.wheel_separation),
      radii_(robot.wheel_radii()),
      motors_(options),
      gyro_(options.gyro, seed),
      battery_(options.battery) {}

std::span<const std::uint8_t> KobukiFirmware::receive(Time now, std::span<const std::uint8_t> bytes) {
  packets_.receive(bytes, [&](std::uint8_t id, std::span<const std::uint8_t> data) { obey(now, id, data); });
  return {};  // answers come with its packets
}

void KobukiFirmware::obey(Time now, std::uint8_t id, std::span<const std::uint8_t> data) {
  if (id == 0x01 && data.size() == 4) motors_.base_control(now, i16_at(data, 0), i16_at(data, 2));
  if (id == 0x09 && data.size() == 2) requested_ |= u16_at(data, 0);
  if (id == 0x0C && data.size() == 2) digital_inputs_ = u16_at(data, 0) & 0x000FU;  // its outputs, wired back
  if (id == 0x0D && data.size() == 13)
    gains_ = {.type = data[0], .p = u32_at(data, 1), .i = u32_at(data, 5), .d = u32_at(data, 9)};
  if (id == 0x0E && data.size() == 1) gains_requested_ = true;
}

std::span<const std::uint8_t> KobukiFirmware::step(Time now, const Body& body) {
  out_.clear();
  if (!started_) started_ = last_step_ = now;
  const double dt = std::max(0.0, (now - *last_step_).to_seconds());
  last_step_ = now;
  motors_.step(now, dt, wheel_speeds(body));
  gyro_.step(body.twist.omega, dt);
  const bool is_charging = body.charger != Charger::none && !battery_.is_full();
  battery_.step(
      is_charging ? kChargingCurrent : kElectronics + motors_.left().current + motors_.right().current, dt);
  const double uptime = (now - *started_).to_seconds() * 1000.0;
  const auto due = static_cast<std::int64_t>(std::floor(uptime / kPeriod + 1e-6));
  if (due < packets_sent_) return out_;
  // What was due and not sent is never sent: a board that was held up goes on from now.
  packets_sent_ = due + 1;
  stamp_ = options_.first_stamp + due * kPeriod + body.clock_offset.nanoseconds / 1'000'000;
  send_packet(body);
  return out_;
}

/// The wheels as its encoders see them.
WheelSpeeds KobukiFirmware::wheel_speeds(const Body& body) const {
  const WheelSpeeds ground = to_wheel_speeds(body.twist, separation_);
  return {ground.left / radii_.left * options_.wheel_radius,
          ground.right / radii_.right * options_.wheel_radius};
}

void KobukiFirmware::send_packet(const Body& body) {
  BasePacket packet;
  put_core(packet, body);
  put_sensors(packet, body);
  put_requested(packet);
  packet.append_to(out_);
}

void KobukiFirmware::put_core(BasePacket& packet, const Body& body) const {
  const ContactReading& touched = body.contacts;
  const auto ticks = [&](std::int32_t counted) {
    return (static_cast<unsigned>(counted) + static_cast<unsigned>(options_.first_ticks)) & 0xFFFFU;
  };
  packet.begin(0x01)
      .u16(static_cast<unsigned>(stamp_) & 0xFFFFU)
      .u8(bits(touched.bumper_right, touched.bumper_centre, touched.bumper_left))
      .u8(bits(touched.drop_right, touched.drop_left))
      .u8(bits(touched.cliff_right, touched.cliff_centre, touched.cliff_left))
      .u16(ticks(body.left_ticks))
      .u16(ticks(body.right_ticks))
      .u8(pwm(motors().left))
      .u8(pwm(motors().right))
      .u8(body.buttons & 7U)
      .u8(charger_code(body))
      .u8(static_cast<unsigned>(std::clamp(std::lround(voltage(body) * 10.0), 0L, 255L)))
      .u8(bits(motors_.left().is_over, motors_.right().is_over));
}

void KobukiFirmware::put_sensors(BasePacket& packet, const Body& body) {
  packet.begin(0x03).u8(0).u8(0).u8(0);  // no dock in sight
  packet.begin(0x04).i16(gyro_.angle_in_hundredths()).i16(gyro_.rate_in_hundredths()).u8(0).u8(0).u8(0);
  const auto floor = [](bool is_cliff) { return is_cliff ? kNoFloor : kFloor; };
  packet.begin(0x05)
      .u16(floor(body.contacts.cliff_right))
      .u16(floor(body.contacts.cliff_centre))
      .u16(floor(body.contacts.cliff_left));
  packet.begin(0x06)
      .u8(in_ten_milliamperes(motors_.left().current))
      .u8(in_ten_milliamperes(motors_.right().current));
  const std::vector<RawGyroSample> samples = gyro_.take_samples();
  packet.begin(0x0D).u8(gyro_.frame_id()).u8(static_cast<unsigned>(3 * samples.size()));
  for (const RawGyroSample& sample : samples) packet.i16(sample[0]).i16(sample[1]).i16(sample[2]);
  packet.begin(0x10).u16(digital_inputs_);
  for (int i = 0; i < 7; ++i) packet.u16(0);  // four analogue inputs, three words unused
}

void KobukiFirmware::put_requested(BasePacket& packet) {
  const auto version = [&](std::uint8_t id, const std::array<unsigned, 3>& parts) {
    packet.begin(id).u8(parts[0]).u8(parts[1]).u8(parts[2]).u8(0);
  };
  if ((requested_ & kHardware) != 0) version(0x0A, kHardwareVersion);
  if ((requested_ & kFirmware) != 0) version(0x0B, kFirmwareVersion);
  if ((requested_ & kUdid) != 0) packet.begin(0x13).u32(kUdidWords[0]).u32(kUdidWords[1]).u32(kUdidWords[2]);
  if (gains_requested_) packet.begin(0x15).u8(gains_.type).u32(gains_.p).u32(gains_.i).u32(gains_.d);
  requested_ = 0;
  gains_requested_ = false;
}

double KobukiFirmware::voltage(const Body& body) const {
  return std::isnan(body.battery_voltage) ? battery_.voltage() : body.battery_voltage;
}

std::uint8_t KobukiFirmware::charger_code(const Body& body) const {
  if (body.charger == Charger::none) return 0;
  const int source = body.charger == Charger::adapter ? 0x10 : 0;
  return static_cast<std::uint8_t>(source | (battery_.is_full() ? 2 : 6));
}

}  // namespace bw::emulators
