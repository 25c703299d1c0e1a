// Firmware of a Parallax Eddie board: one reply to each line, nothing unasked. With WATCH, on from the start
// where it has it, the motors are switched off when nothing is heard for a second.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "components/emulators/eddie/eddie_command.hpp"
#include "components/emulators/eddie/eddie_drive.hpp"
#include "components/emulators/eddie/eddie_options.hpp"
#include "components/emulators/eddie/eddie_pins.hpp"
#include "components/emulators/emulated_base.hpp"
#include "components/model/robot.hpp"

namespace bw::emulators {

class EddieFirmware final : public EmulatedBase {
 public:
  EddieFirmware(const EddieOptions& options, const Robot& robot);

  std::span<const std::uint8_t> receive(Time now, std::span<const std::uint8_t> bytes) override;
  std::span<const std::uint8_t> step(Time now, const Body& body) override;
  WheelSpeeds motors() const override;
  double wheel_radius() const override { return wheel_radius_; }
  std::vector<Beam> beams() const override;

 private:
  struct Positions {
    std::int64_t left = 0, right = 0;
  };

  void obey(Time now, const EddieCommand& command);
  bool move(Time now, const EddieCommand& command);
  std::string answer(const EddieCommand& command);
  std::string speeds() const;
  std::string heading() const;
  std::string pings() const;
  std::string converter() const;
  void count(Time now, const Body& body);
  Positions since_reset() const;

  EddieOptions options_;
  double wheel_radius_;
  double ticks_per_position_;
  double metres_per_position_;
  double speed_factor_;  ///< positions/s for one unit of GOSPD
  LineEditor editor_;
  EddieDrive drive_;
  EddiePins pins_;
  Battery battery_;
  bool is_verbose_ = false;
  Duration watch_;  ///< 0: off
  std::optional<Time> last_step_;
  Time heard_;
  Body body_;
  std::int64_t left_ticks_ = 0, right_ticks_ = 0;  ///< unwrapped
  Positions now_, reset_;
  struct Counted {
    Time time;
    Positions positions;
  };
  std::deque<Counted> last_half_second_;
  std::string reply_;  ///< to the lines that came last
  std::vector<std::uint8_t> out_;
};

}  // namespace bw::emulators
