// Sweeps drawn from shapes, for tests of the detector. The scanner's frame is O unless X_OL says otherwise.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "components/people/detector/beams.hpp"
#include "components/world/laser_scanner.hpp"

namespace bw::people {

class Scanner {
 public:
  explicit Scanner(double noise = 0.0, std::uint64_t seed = 1, double field_of_view = 1.5 * std::numbers::pi,
                   int beams = 720)
      : options_(laser(noise, field_of_view, beams)), scanner_(options_, Random(seed)) {}

  /// Valid until the next call.
  LaserSweep scan(const StaticObstacles& walls, const std::vector<Disc>& legs, const Pose2& X_OL,
                  double seconds) {
    scan_ = scanner_.scan(StaticScene(walls, std::nullopt), legs, X_OL);
    return {Time::seconds(seconds), X_OL,        scan_.angle_min, scan_.angle_increment, options_.range_min,
            options_.range_max,     scan_.ranges};
  }

 private:
  static LaserOptions laser(double noise, double field_of_view, int beams) {
    LaserOptions options;
    options.range_noise = noise;
    options.field_of_view = field_of_view;
    options.beams = beams;
    options.range_max = 10.0;
    return options;
  }

  LaserOptions options_;
  LaserScanner scanner_;
  LaserScan scan_;
};

inline StaticObstacles square_room(double half) {
  const std::vector<Vector2> corners = {{half, half}, {-half, half}, {-half, -half}, {half, -half}};
  StaticObstacles walls;
  for (std::size_t i = 0; i < 4; ++i) walls.segments.push_back({corners[i], corners[(i + 1) % 4]});
  return walls;
}

}  // namespace bw::people
