// A drive with known truth and the measurements of it, for the tests of filters. 0.8 m/s, sinusoidal turn
// rate (localization/evidence.md 9.1): encoders and gyro 100 Hz, compass 10 Hz, receiver 5 Hz unless said
// otherwise.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "components/localization/measurements.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"
#include "components/model/wheel_step.hpp"

namespace bw::localization {

struct DriveOptions {
  std::uint64_t seed = 1;
  double seconds = 60.0;
  double speed = 0.8;
  double turn_rate_amplitude = 0.5;  ///< [rad/s], period 20 s
  Pose2 start;
  double separation = 0.4;
  double wheel_variance = 1e-4;  ///< k [m]
  double tick = 0.0;             ///< travel of a wheel between two counts [m]; 0: as fine as can be
  double gyro_sigma = 0.01;      ///< 0: no gyro
  double gyro_bias = 0.0;
  double compass_sigma = 0.05;  ///< 0: no compass
  double compass_offset = 0.0;
  double gps_sigma = 0.5;  ///< 0: no receiver
  int gps_every = 20;      ///< wheel steps
  double slip_from = 1e9;  ///< [s] then the wheels rotate so many times as far as the robot moves:
  double slip_left = 2.0;
  double slip_right = 2.0;
  double slip_for = 1.0;
  double slip_every = 30.0;
};

enum Source { kWheels, kGyro, kCompass, kGps };

struct Drive {
  std::vector<Measurement> measurements;  ///< by stamp
  std::vector<Pose2> truth;               ///< truth[i] at step_time(i)
};

constexpr Duration kStep = Duration::milliseconds(10);
constexpr Time kStart{1'000'000'000'000};  // 1000 s
inline Time step_time(int i) { return kStart + kStep * i; }

inline Drive simulate(const DriveOptions& o) {
  Random random(o.seed);
  Drive drive;
  Pose2 X = o.start;
  drive.truth.push_back(X);
  double went_left = 0.0, went_right = 0.0;
  const int steps = static_cast<int>(std::lround(o.seconds * 100.0));
  for (int i = 1; i <= steps; ++i) {
    const double t = (i - 0.5) * 0.01;
    const Twist2 twist{o.speed, o.turn_rate_amplitude * std::sin(2.0 * std::numbers::pi * t / 20.0)};
    X = advance_exact(X, twist, 0.01);
    drive.truth.push_back(X);
    const Time now = step_time(i);

    const bool slips = t >= o.slip_from && std::fmod(t - o.slip_from, o.slip_every) < o.slip_for;
    const WheelSpeeds wheels = to_wheel_speeds(twist, o.separation);
    const auto travel = [&](double speed, double slip) {
      const double distance = 0.01 * speed;
      return (slips ? slip : 1.0) * distance +
             std::sqrt(o.wheel_variance * std::abs(distance)) * random.normal();
    };
    const auto counted = [&](double& went, double distance) {
      const double before = o.tick > 0.0 ? std::floor(went / o.tick) : 0.0;
      went += distance;
      return o.tick > 0.0 ? o.tick * (std::floor(went / o.tick) - before) : distance;
    };
    const double left = counted(went_left, travel(wheels.left, o.slip_left));
    const double right = counted(went_right, travel(wheels.right, o.slip_right));
    if (o.gyro_sigma > 0.0) {
      drive.measurements.push_back(GyroReading{now, kGyro,
                                               twist.omega + o.gyro_bias + o.gyro_sigma * random.normal(),
                                               o.gyro_sigma * o.gyro_sigma});
    }
    WheelStep step = step_from_wheels(now, kStep, left, right, o.separation, o.wheel_variance);
    step.covariance = step_from_wheels(now, kStep, 0.01 * wheels.left, 0.01 * wheels.right, o.separation,
                                       o.wheel_variance)
                          .covariance;  // of the true path: noise in its own variance is not under test
    step.rounding = rotation_rounding(o.tick, o.separation);
    step.source = kWheels;
    drive.measurements.push_back(step);
    if (o.gps_sigma > 0.0 && i % o.gps_every == 0) {
      PositionFix fix;
      fix.time = now;
      fix.source = kGps;
      fix.position = X.position() + Vector2(o.gps_sigma * random.normal(), o.gps_sigma * random.normal());
      fix.covariance = o.gps_sigma * o.gps_sigma * Eigen::Matrix2d::Identity();
      drive.measurements.push_back(fix);
    }
    if (o.compass_sigma > 0.0 && i % 10 == 0) {
      drive.measurements.push_back(HeadingReading{
          now, kCompass, wrap_angle(X.theta + o.compass_offset + o.compass_sigma * random.normal()),
          o.compass_sigma * o.compass_sigma});
    }
  }
  return drive;
}

}  // namespace bw::localization
