// A Kobuki on a cable (TurtleBot 2, QBot 2e): its packets to readings, wheel speeds to its commands.
// Protocol, sources and what is doubtful: components/robot_base/kobuki/README.md.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "components/robot_base/driver.hpp"
#include "components/robot_base/held_report.hpp"
#include "components/robot_base/kobuki/board_clock.hpp"
#include "components/robot_base/kobuki/commands.hpp"
#include "components/robot_base/kobuki/feedback.hpp"
#include "components/robot_base/kobuki/packet_reader.hpp"
#include "components/robot_base/kobuki/unwrapped.hpp"
#include "components/robot_base/unknown_device.hpp"
#include "runtime/base/field.hpp"

namespace bw::kobuki {

struct GainOptions {
  /// give the board these gains instead of those of the factory (set by code alone)
  bool is_set = false;
  Gains gains;
};

struct KobukiOptions {
  /// [m] by which the firmware turns speed and radius into wheels, of its protocol; the robot's own is
  /// wheel_separation
  static constexpr double kFirmwareSeparation = 0.230;
  /// [s] without a packet after which the base counts as lost: five that are missing, one comes every 0.02 s
  static constexpr double kSilence = 0.1;
  GainOptions gains;

  template <class Visitor>
  void fields(Visitor& v) {
    v.retired({"firmware_separation", "silence", "gains"}, "a constant of kobuki.hpp");
  }
};

/// poll() reads, command() writes. After each opening the first thing written is a stop, and stops are all
/// that is written until two packets were understood. Nothing here makes the base stand when commands cease,
/// and no document says that its firmware does.
class Kobuki : public Driver {
 public:
  Kobuki(const KobukiOptions& options, const WheelRadii& radii, std::unique_ptr<ByteLink> link);

  /// Makes the base stand, whatever it does. Behind AA 55 alone the next frame's first byte is a length of
  /// 170: so many frames, that the last of them is heard.
  static Bytes stop_frame();
  Readings poll(Time now) override;
  bool command(Time now, const WheelSpeeds& wheels) override;
  void stop(Time now) override;
  std::map<std::string, std::uint64_t> counters() const override;
  BaseFacts facts() const override {
    return {.has_gyro = true, .has_battery = true, .battery_low = 14.0, .battery_empty = 13.2};
  }

 private:
  void begin_session(Time now);
  void take(Time now, const std::vector<Feedback>& packets, Readings& readings);
  void take_core(Time now, Time stamp, const Core& core, Readings& readings);
  void count(Time now, const Core& core);
  int periods_since(std::uint16_t stamp) const;
  void remember(const Feedback& packet);
  LinkState heard(Time now, const LinkState& cable);
  void tell(Time now, Readings& readings);
  void ask(Time now);
  bool is_recognised() const { return session_.packets >= 2; }

  /// What belongs to one opening of the cable.
  struct Session {
    Time opened;
    std::optional<Time> heard;  ///< the newest packet
    std::uint64_t packets = 0;
    bool was_heard_since_write = false;
    std::optional<Time> written;  ///< the newest base control
    SpeedAndRadius motion;        ///< that it asked for
    std::optional<Time> asked;
    bool has_versions = false, has_gains = false;
  };

  KobukiOptions options_;
  WheelRadii radii_;
  std::unique_ptr<ByteLink> link_;
  std::uint64_t openings_ = 0;
  Session session_;
  PacketReader reader_;
  BoardClock clock_;
  WheelCounter left_, right_;
  Heading heading_;
  std::optional<std::uint16_t> stamp_;  ///< of the newest core
  std::optional<Time> arrival_;         ///< of the newest
  Duration gap_;                        ///< between the newest two reads that had one
  bool clock_jumped_ = false;           ///< at the newest
  UnknownDevice unknown_device_;
  HeldReport faults_;
  HeldReport warnings_{Duration::milliseconds(10'000)};
  std::uint64_t encoder_jumps_ = 0, missed_ = 0, skipped_ = 0;
  std::optional<Version> hardware_, firmware_;
};

}  // namespace bw::kobuki
