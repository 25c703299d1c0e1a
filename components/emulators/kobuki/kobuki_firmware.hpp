// Firmware of a Kobuki base (QBot 2e): a packet every 20 ms, commands as they come. Bumpers, cliffs and
// dropped wheels are told and nothing else; as far as is known it drives on as commanded last when commands
// cease (KobukiOptions::stops_by_itself).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "components/emulators/emulated_base.hpp"
#include "components/emulators/kobuki/base_packet.hpp"
#include "components/emulators/kobuki/host_packets.hpp"
#include "components/emulators/kobuki/kobuki_gyro.hpp"
#include "components/emulators/kobuki/kobuki_motors.hpp"
#include "components/model/robot.hpp"

namespace bw::emulators {

class KobukiFirmware final : public EmulatedBase {
 public:
  KobukiFirmware(const KobukiOptions& options, const Robot& robot, std::uint64_t seed);

  std::span<const std::uint8_t> receive(Time now, std::span<const std::uint8_t> bytes) override;
  std::span<const std::uint8_t> step(Time now, const Body& body) override;
  WheelSpeeds motors() const override { return motors_.speeds(); }
  double wheel_radius() const override { return options_.wheel_radius; }

 private:
  /// P, I, D of the wheels' loop as the protocol carries them, times 1000; told, not obeyed.
  struct Gains {
    std::uint8_t type = 0;
    std::uint32_t p = 100'000, i = 100, d = 2'000;
  };

  void obey(Time now, std::uint8_t id, std::span<const std::uint8_t> data);
  void send_packet(const Body& body);
  void put_core(BasePacket& packet, const Body& body) const;
  void put_sensors(BasePacket& packet, const Body& body);
  void put_requested(BasePacket& packet);
  WheelSpeeds wheel_speeds(const Body& body) const;
  double voltage(const Body& body) const;
  std::uint8_t charger_code(const Body& body) const;

  KobukiOptions options_;
  double separation_;
  WheelRadii radii_;
  HostPackets packets_;
  KobukiMotors motors_;
  KobukiGyro gyro_;
  Battery battery_;
  Gains gains_;
  unsigned requested_ = 0;  ///< flags of the request
  bool gains_requested_ = false;
  unsigned digital_inputs_ = 0;
  std::optional<Time> started_, last_step_;
  std::int64_t packets_sent_ = 0;
  std::int64_t stamp_ = 0;  ///< [ms] of its clock
  std::vector<std::uint8_t> out_;
};

}  // namespace bw::emulators
