// The test scenes of CrowdNav (Chen, Liu, Kreiss and Alahi 2019): a robot and five people who cross, from the
// seeds of its 500 test cases (protocols.md 8.11). Metres.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>

#include "runtime/base/pose2.hpp"

namespace bw {

enum class CrowdNavCrossing {
  circle,  ///< of 4 m radius, each to the opposite position
  square,  ///< of 10 m, each from one half to the other
};

struct CrowdNavPerson {
  Vector2 start{0.0, 0.0};
  Vector2 goal{0.0, 0.0};
};

struct CrowdNavScene {
  std::string name;
  Pose2 start{0.0, -4.0, 0.5 * std::numbers::pi};
  Vector2 goal{0.0, 4.0};
  std::array<CrowdNavPerson, 5> people;
};

inline constexpr int kCrowdNavCases = 500;
inline constexpr double kCrowdNavRadius = 0.3;  // [m] of the robot and of everybody

/// Case 0, 1, ..., 499 has the seed 1000 + case.
CrowdNavScene crowdnav_scene(CrowdNavCrossing crossing, int test_case);

/// Uniform in [0, 1) as NumPy's legacy generator draws it.
class CrowdNavRandom {
 public:
  explicit CrowdNavRandom(std::uint32_t seed) : engine_(seed) {}
  double uniform() {
    const double high = static_cast<double>(engine_() >> 5);  // 27 bits, and 26 below them
    const double low = static_cast<double>(engine_() >> 6);
    return (high * 0x1.0p26 + low) * 0x1.0p-53;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace bw
