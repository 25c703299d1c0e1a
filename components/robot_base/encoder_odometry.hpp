// Pose and twist from two wrapping encoder counters: exact arcs (model/README.md 2.1), covariance by the
// wheel noise model of model/README.md 2.2.
//
//   ds_R = 2 pi r_R ticks_R / ticks_per_revolution, ds_L likewise; r_L = 2 r / (1 + E_d), r_R = E_d r_L
//   ds = (ds_R + ds_L) / 2,  dtheta = (ds_R - ds_L) / b
//   P+ = F P F^T + G diag(k |ds_R|, k |ds_L|) G^T,  F = d pose+ / d pose,  G = d pose+ / d (ds_R, ds_L)
//
// A counter that moves further than the wheels can is not motion. One such reading is dropped and the next
// good one bridges it; two that agree with each other are a new count (the board restarted or lost counts):
// odometry goes on from there and leaves the unknown part out. Old stamps are never motion: a driver stamps
// by the clock of its caller (driver.hpp). A reference ahead of that clock is of before the clock went back,
// and the next reading replaces it.
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "components/model/odometry_state.hpp"
#include "components/model/robot.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Encoder counts since power-up; int32 counters wrap.
struct EncoderCounts {
  Time time;
  std::int32_t left = 0;
  std::int32_t right = 0;
};

struct OdometryOptions {
  double variance_per_metre = 5e-4;
  /// a wheel faster than this many times its top speed is an encoder fault (set by code alone)
  double speed_margin = 2.0;
  /// [s] time over which speed is averaged, three readings at 50 Hz; a driver of coarse encoders asks for
  /// more (set by code alone)
  double velocity_window = 0.06;

  template <class Visitor>
  void fields(Visitor& v) {
    v("variance_per_metre", variance_per_metre,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc =
           "wheel travel variance per metre (k of model/README.md 2.2), for the localization too; raise it on "
           "slippery floors and for wheels that are not equal"});
    v.retired({"speed_margin", "velocity_window"}, "a constant of encoder_odometry.hpp");
  }
};

/// What became of a reading.
enum class CountsStatus {
  first,  ///< sets the reference
  moved,  ///< integrated
  stale,  ///< stamp not after the previous one; ignored
  jump,   ///< further than the wheels can go; ignored
  reset,  ///< like jump, and the counters are back near zero
  /// second reading that agrees with a jump or reset, or the first after the clock went back: the new
  /// reference
  rebased
};

/// Of the wheels between two readings [m].
struct WheelTravel {
  double seconds = 0.0;
  double left = 0.0, right = 0.0;
};

struct OdometryFaults {
  std::uint64_t jumps = 0;
  std::uint64_t resets = 0;
  std::uint64_t stale = 0;
};

class EncoderOdometry {
 public:
  EncoderOdometry(const Robot& robot, const OdometryOptions& options);

  /// `now`: by the clock that stamps the readings.
  CountsStatus add(Time now, const EncoderCounts& counts);
  const OdometryState& state() const { return state_; }
  /// Of the reading that was integrated last.
  const WheelTravel& travel() const { return travel_; }
  const OdometryFaults& faults() const { return faults_; }

 private:
  bool possible(const EncoderCounts& from, const EncoderCounts& to) const;
  /// Speed is not averaged over what was before `time`.
  void restart_history(Time time);
  void integrate(double ds_left, double ds_right);
  void measure_twist();

  OdometryOptions options_;
  double separation_;
  WheelRadii radii_;
  double metres_per_tick_;  ///< mean of both wheels
  double left_metres_per_tick_, right_metres_per_tick_;
  double wheel_speed_max_;
  OdometryState state_;
  WheelTravel travel_;
  OdometryFaults faults_;
  std::optional<EncoderCounts> reference_;
  std::optional<EncoderCounts> suspect_;

  /// Travel and rotation up to a moment; the difference of two gives the mean twist between them.
  struct Travelled {
    Time time;
    double distance = 0.0;
    double rotation = 0.0;
  };
  static constexpr int kHistory = 64;
  Travelled history_[kHistory];
  int history_size_ = 0;
};

}  // namespace bw
