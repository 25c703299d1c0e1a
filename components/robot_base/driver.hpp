// What robot_base asks of a base: take wheel speeds, tell what was measured. A simulated world, a Kobuki and
// an Eddie are all one of these; another project adds its own by driver_registry.hpp. A driver decides
// nothing: time-outs, reactions and latches are robot_base's, the same for all bases.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "components/model/differential_drive.hpp"
#include "components/model/robot.hpp"
#include "components/robot_base/readings.hpp"

namespace bw {

class Setup;
struct PortOptions;

/// What a driver is made with, valid while it is made.
struct DriverContext {
  Setup& setup;  ///< for drivers over topics; others leave it alone
  const Robot& robot;
  /// The cable, for a driver that has one. `stop_frame`: the bytes that make the base stand, which the port's
  /// guardian sends when this process is killed or hangs: also in the middle of a command, of which they must
  /// not become a part. Empty: the base has no such bytes, and drives on as its firmware likes.
  std::function<std::unique_ptr<ByteLink>(const PortOptions&, std::vector<std::uint8_t> stop_frame)>
      open_link;
  /// To be called when something came that should not wait for the next poll; kept as long as the driver
  /// likes.
  std::function<void(Time now)> wake;
};

/// A ranging sensor that is part of the base.
struct Ranger {
  std::string frame;  ///< of the robot's sensors, in which its beam points along x
  bool is_infrared = false;
  double field_of_view = 0.0;               ///< [rad]
  double min_range = 0.0, max_range = 0.0;  ///< [m]
};

/// What the driver knows of its base before it is heard.
struct BaseFacts {
  bool has_gyro = false;         ///< tells Readings::gyro
  bool has_battery = false;      ///< tells Readings::battery
  double response = 0.1;         ///< from command() to the counts that show it, at most [s]
  double velocity_window = 0.0;  ///< over which speed from its counts must be averaged at least [s]
  double battery_low = 0.0;      ///< warned of below [V]; 0: not known
  double battery_empty = 0.0;    ///< not driven below [V]; 0: not known
};

class Driver {
 public:
  virtual ~Driver() = default;
  /// What came since the last call. Never blocks. Called every 10 ms, and after `wake`.
  virtual Readings poll(Time now) = 0;
  /// Rotates the wheels at these ground speeds [m/s] from `now` on; called every 10 ms, whether or not they
  /// changed. False when they cannot be told to the base now.
  virtual bool command(Time now, const WheelSpeeds& wheels) = 0;
  /// The command must be on its way before the process ends; the cable may be gone. Never blocks. Nobody
  /// polls until it is active again: a driver with a cable says so to it (ByteLink::rest).
  virtual void stop(Time now) { static_cast<void>(command(now, {})); }
  virtual std::vector<Ranger> rangers() const { return {}; }
  /// For diagnostics, asked for once a second: frames, bad checksums, bytes thrown away, resets.
  virtual std::map<std::string, std::uint64_t> counters() const { return {}; }
  virtual BaseFacts facts() const { return {}; }
};

}  // namespace bw
