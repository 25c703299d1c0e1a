// What a robot on a route senses: wheel steps with noise, and sweeps of a scanner of 270 degrees and 10 m.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "components/localization/laser_reading.hpp"
#include "components/localization/measurements.hpp"
#include "components/world/laser_scanner.hpp"
#include "tests/components/localization/laser_route.hpp"

namespace bw::localization::test {

struct SensorNoise {
  double range = 0.02;                 ///< [m]
  int people = 0;                      ///< within 4 m or so, in the way of beams
  double random_returns = 0.0;         ///< share of beams that end anywhere before they should
  double distance = 1e-3;              ///< variance of the distance, per metre [m]
  double rotation_by_distance = 1e-3;  ///< variance of the rotation, per metre [rad^2/m]
  double rotation_by_rotation = 5e-3;  ///< the same, per radian [rad]
};

class SensedRobot {
 public:
  SensedRobot(const OccupancyGrid& map, const SensorNoise& noise, std::uint64_t seed)
      : noise_(noise),
        random_(seed),
        scene_({}, map),
        scanner_({.beams = 360, .range_max = kRangeMax, .range_noise = noise.range}, Random(seed + 1000)) {}

  static constexpr double kRangeMax = 10.0;

  WheelStep wheel_step(Time time, const Pose2& from, const Pose2& to) {
    const Pose2 by = inverse(from) * to;
    const double distance = std::hypot(by.x, by.y);
    WheelStep step{.time = time, .over = Duration::milliseconds(50)};
    step.covariance(0, 0) = noise_.distance * distance + 1e-10;
    step.covariance(1, 1) =
        noise_.rotation_by_distance * distance + noise_.rotation_by_rotation * std::abs(by.theta) + 1e-10;
    step.distance = distance + std::sqrt(step.covariance(0, 0)) * random_.normal();
    step.rotation = by.theta + std::sqrt(step.covariance(1, 1)) * random_.normal();
    return step;
  }

  /// Valid until the next sweep.
  LaserReading sweep(Time time, const Pose2& X_MB) {
    move_people(X_MB);
    LaserScan scan = scanner_.scan(scene_, people_, X_MB * kMount);
    ranges_ = scan.ranges;
    for (float& range : ranges_) {
      if (noise_.random_returns > 0.0 && random_.uniform() < noise_.random_returns) {
        range =
            static_cast<float>(random_.uniform(0.1, std::min<double>(static_cast<double>(range), kRangeMax)));
      }
    }
    return {{.time = time,
             .X_FL = kMount,
             .angle_min = scan.angle_min,
             .angle_increment = scan.angle_increment,
             .range_min = 0.05,
             .range_max = kRangeMax,
             .ranges = ranges_},
            1};
  }

 private:
  static constexpr Pose2 kMount{0.1, 0.0, 0.0};

  // Discs of 0.2 m that walk straight at 1 m/s (sweeps are 0.1 s apart), and come anew when far away.
  void move_people(const Pose2& X_MB) {
    const auto count = static_cast<std::size_t>(noise_.people);
    if (people_.size() != count) {
      people_.assign(count, {});
      velocities_.assign(count, {0.0, 0.0});
    }
    for (std::size_t i = 0; i < count; ++i) {
      people_[i].center += 0.1 * velocities_[i];
      people_[i].radius = 0.2;
      const double far = (people_[i].center - X_MB.position()).norm();
      if (far > 0.5 && far < 4.0) continue;
      people_[i].center =
          X_MB.position() + random_.uniform(1.0, 3.5) * direction(random_.uniform(-3.15, 3.15));
      velocities_[i] = direction(random_.uniform(-3.15, 3.15));
    }
  }

  SensorNoise noise_;
  Random random_;
  StaticScene scene_;
  LaserScanner scanner_;
  std::vector<Disc> people_;
  std::vector<Vector2> velocities_;
  std::vector<float> ranges_;
};

}  // namespace bw::localization::test
