// An inertial unit that gives the turn rate (gyro) and the heading (compass), both with bias and white noise.
#pragma once

#include "components/model/random.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

struct ImuOptions {
  double rate = 50.0;
  double gyro_bias = 0.0;
  double gyro_noise = 0.005;
  /// [rad] constant error of the compass (set by code alone)
  double heading_bias = 0.0;
  double heading_noise = 0.02;
  /// frame_id of the readings, as the robot files have it
  static constexpr const char* kFrame = "imu";

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "Hz", .min = 0, .max = 1000, .doc = "readings per second; 0: no IMU"});
    v("gyro_bias", gyro_bias,
      {.unit = "rad/s", .min = -1, .max = 1, .doc = "constant error of the turn rate"});
    v("gyro_noise", gyro_noise,
      {.unit = "rad/s", .min = 0, .max = 1, .doc = "standard deviation of the turn rate"});
    v("heading_noise", heading_noise,
      {.unit = "rad", .min = 0, .max = 3.2, .doc = "standard deviation of the compass"});
    v.retired({"frame"}, "a constant of imu.hpp");
  }
};

struct ImuReading {
  double turn_rate = 0.0;  ///< about z [rad/s]
  double heading = 0.0;    ///< in map, counter-clockwise from its x axis (east) [rad]
};

class Imu {
 public:
  Imu(const ImuOptions& options, Random random) : options_(options), random_(random) {}

  ImuReading read(const Pose2& X_map_base, const Twist2& twist) {
    ImuReading reading;
    reading.turn_rate = twist.omega + options_.gyro_bias + options_.gyro_noise * random_.normal();
    reading.heading =
        wrap_angle(X_map_base.theta + options_.heading_bias + options_.heading_noise * random_.normal());
    return reading;
  }

 private:
  ImuOptions options_;
  Random random_;
};

}  // namespace bw
