// The test scenes of CrowdNav (Chen, Liu, Kreiss and Alahi 2019): a robot and five people who cross; and of CrowdNav++
// (Liu et al. 2023): a robot among twenty. From the seeds of their 500 test cases (protocols.md 8.11, 8.14). Metres.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

inline constexpr int kCrowdNavCases = 500;
inline constexpr double kCrowdNavRadius = 0.3;  // [m] of the robot, and of everybody but in the mixed crowd

enum class CrowdNavCrossing {
  circle,       ///< of 4 m radius, each to the opposite position
  square,       ///< of 10 m, each from one half to the other
  crowd,        ///< CrowdNav++: twenty about a circle of 8.5 m; who arrives goes, and somebody else comes
  mixed_crowd,  ///< and people differ in radius and speed, and draw other goals on the way
};

inline constexpr std::array kCrowdNavCrossings = {CrowdNavCrossing::circle, CrowdNavCrossing::square,
                                                  CrowdNavCrossing::crowd, CrowdNavCrossing::mixed_crowd};
const char* to_text(CrowdNavCrossing crossing);

struct CrowdNavPerson {
  Vector2 start{0.0, 0.0};
  Vector2 goal{0.0, 0.0};
  double radius = kCrowdNavRadius;
  double speed = 1.0;  ///< at most [m/s]
  double look = 10.0;  ///< [m] how far they look at others
};

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

/// In what the two tests differ.
struct CrowdNavRules {
  double time_limit = 25.0;     ///< [s]; a step that begins a second before is the last one
  double people_margin = 0.0;   ///< [m] by which people widen themselves and everybody
  std::size_t neighbours = 10;  ///< at most, that somebody looks at
  double sensed_range = std::numeric_limits<double>::infinity();  ///< [m] of the robot, between outlines
  bool newcomers = false;  ///< who arrives is gone, and somebody else begins on the circle
  bool mixed = false;  ///< radii and speeds differ; every 5 s each has another goal with a chance of a half
};

struct CrowdNavScene {
  std::string name;
  Pose2 start{0.0, -4.0, 0.5 * std::numbers::pi};
  Vector2 goal{0.0, 4.0};
  std::vector<CrowdNavPerson> people;
  CrowdNavRules rules;
  CrowdNavRandom random{0};  ///< goes on from here
};

/// Case 0, 1, ..., 499 has the seed 1000 + case; of the crowds 1425 + case, of which the even ones were published.
CrowdNavScene crowdnav_scene(CrowdNavCrossing crossing, int test_case);

/// Somebody on CrowdNav++'s circle, clear of all that are there and of their goals.
CrowdNavPerson crowdnav_newcomer(CrowdNavRandom& random, bool mixed,
                                 const std::vector<CrowdNavPerson>& there);
/// Another goal there for `self`.
Vector2 crowdnav_other_goal(CrowdNavRandom& random, const CrowdNavPerson& self,
                            const std::vector<CrowdNavPerson>& others);

}  // namespace bw
