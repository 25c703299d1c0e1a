// Sweeps of an ideal laser at the middle of the robot, for tests.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "components/model/obstacles.hpp"
#include "components/safety/sweep.hpp"

namespace bw::safety {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Owns its ranges, for tests to spoil.
struct Sweep : LaserSweep {
  std::vector<float> ranges;

  LaserSweep view() const {
    LaserSweep all = *this;
    all.ranges = ranges;
    return all;
  }
};

/// 720 beams over 270 degrees among discs (base_link), `background` [m] behind them.
inline Sweep sweep_of(const std::vector<Disc>& discs, float background = 8.0F) {
  constexpr int kBeams = 720;
  Sweep sweep{{.angle_min = -0.75 * std::numbers::pi,
               .angle_increment = 1.5 * std::numbers::pi / (kBeams - 1),
               .range_min = 0.05,
               .range_max = 20.0,
               .angle_max = 0.75 * std::numbers::pi},
              std::vector<float>(kBeams, background)};
  for (int i = 0; i < kBeams; ++i) {
    const Vector2 beam = direction(sweep.angle_min + i * sweep.angle_increment);
    float& range = sweep.ranges[static_cast<std::size_t>(i)];
    for (const Disc& disc : discs) {
      const double along = disc.center.dot(beam);
      const double off = cross(beam, disc.center);
      if (along <= 0.0 || std::abs(off) >= disc.radius) continue;
      const double hit = along - std::sqrt(disc.radius * disc.radius - off * off);
      range = std::min(range, static_cast<float>(hit));
    }
  }
  return sweep;
}

}  // namespace bw::safety
