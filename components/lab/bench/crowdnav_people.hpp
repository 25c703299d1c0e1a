// Who walks in CrowdNav's scenes: everybody by ORCA, deciding every quarter of a second (orca/theory.md 5.6,
// protocols.md 8.11).
// Metres, seconds.
#pragma once

#include <vector>

#include "components/lab/bench/crowdnav_scene.hpp"

namespace bw {

inline constexpr double kCrowdNavStep = 0.25;  // [s]

/// A disc of kCrowdNavRadius.
struct CrowdNavAgent {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
};

/// CrowdNav's ORCA policy: the velocity of `self` on the way to `goal`, at most 1 m/s, when everybody is
/// wider by 0.01 m + `safety_space`, and expected to share the avoiding.
Vector2 crowdnav_orca(const CrowdNavAgent& self, const Vector2& goal,
                      const std::vector<CrowdNavAgent>& others, double safety_space);

/// The people of a scene.
class CrowdNavPeople {
 public:
  explicit CrowdNavPeople(const CrowdNavScene& scene);

  const std::vector<CrowdNavAgent>& agents() const { return agents_; }

  /// What they decide now; `robot` is one of them if they see it. They go on walking round their goals.
  std::vector<Vector2> decide(const CrowdNavAgent* robot) const;

  /// Each walks `velocities` [m/s] for `duration` [s].
  void walk(const std::vector<Vector2>& velocities, double duration);

 private:
  std::vector<CrowdNavAgent> agents_;
  std::vector<Vector2> goals_;
};

}  // namespace bw
