// A differential-drive base on a floor with walls: wheels with limited acceleration, slip, and encoders that
// err.
//
// Every step the rim speeds move towards the command by at most wheel_acceleration * dt, and the pose follows
// the exact arc of their mean over the step. Encoders count rim travel by model/README.md 2.2:
//
//   measured = true (1 + scale + s e / 2) + N(0, k |true|)   with s = +1 right, -1 left
//
// then whole ticks in a counter that wraps at 32 bits. A wall stops the base: a step that would bring its
// footprint further into a wall keeps the rotation and loses the rest, and the wheels stall; of a polygon the
// rotation as well where that alone goes further in.
#pragma once

#include <cstdint>

#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"
#include "components/model/robot.hpp"
#include "components/world/static_scene.hpp"

namespace bw {

struct DriveOptions {
  /// [m/s^2] rim acceleration the motors and tyres can give (set by code alone)
  double wheel_acceleration = 4.0;
  /// [rad/s] top wheel speed
  static constexpr double kWheelSpeedMax = 40.0;
  double slip = 0.0;
  double scale = 0.0;
  double mismatch = 0.0;
  /// the wheels stand this share further apart than the robot file says (set by code alone)
  double separation_error = 0.0;
  double noise = 0.0;
  std::int64_t first_tick = 0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("slip", slip,
      {.min = 0, .max = 0.9, .doc = "share of the rim travel lost on the floor; encoders do not see it"});
    v("scale", scale,
      {.min = -0.5, .max = 0.5, .doc = "common error of both encoders: 0.01 counts 1 % too much"});
    v("mismatch", mismatch,
      {.min = -0.5,
       .max = 0.5,
       .doc = "e of model/README.md 2.2: the right encoder counts this share more than the left"});
    v("noise", noise,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc = "k of model/README.md 2.2: variance of encoder travel per metre"});
    v("first_tick", first_tick,
      {.min = -2147483648.0,
       .max = 2147483647.0,
       .doc = "counters at the start; near the limits to see them wrap"});
    v.retired({"separation_error"}, "a constant of drive_model.hpp");
  }
};

/// Wheel rates [rad/s].
struct WheelCommand {
  double left = 0.0;
  double right = 0.0;
};

/// Encoder counters; they wrap.
struct EncoderTicks {
  std::int32_t left = 0;
  std::int32_t right = 0;
  bool operator==(const EncoderTicks&) const = default;
};

class DriveModel {
 public:
  DriveModel(const DriveOptions& options, const Robot& robot, const Pose2& start, Random random);

  /// Holds `command` until the next one. False, and the base brakes, when it is not finite.
  bool command(const WheelCommand& command);

  /// Moves by dt [s]; true when a wall held the base back.
  bool step(double dt, const StaticScene& scene);

  const Pose2& pose() const { return pose_; }  ///< of base_link in map
  Twist2 twist() const;                        ///< true body velocity now
  const Footprint& footprint() const { return footprint_; }
  void set_footprint(const Footprint& footprint) { footprint_ = footprint; }
  EncoderTicks ticks() const;

 private:
  DriveOptions options_;
  Robot robot_;
  Footprint footprint_;
  Pose2 pose_;
  Random random_;
  WheelSpeeds target_;          ///< rim speeds asked for [m/s]
  WheelSpeeds rim_;             ///< rim speeds now [m/s]
  double measured_left_ = 0.0;  ///< rim travel as the encoder sees it [m]
  double measured_right_ = 0.0;
};

}  // namespace bw
