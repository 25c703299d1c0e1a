// Who walks in CrowdNav's scenes: everybody by ORCA, deciding every quarter of a second (orca/theory.md 5.6,
// protocols.md 8.11).
// Metres, seconds.
#pragma once

#include <cstdint>
#include <vector>

#include "components/lab/bench/crowdnav_scene.hpp"

namespace bw {

inline constexpr double kCrowdNavStep = 0.25;  // [s]

struct CrowdNavAgent {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  double radius = kCrowdNavRadius;
  double speed = 1.0;    ///< at most [m/s]
  std::uint32_t id = 0;  ///< counts those who came
  double look = 10.0;    ///< [m] how far they look at others
};

/// What somebody took the others for when first there, and goes by ever since, whoever comes in their places: the
/// published simulation of CrowdNav++ is so.
struct CrowdNavBelief {
  double look = 10.0;         ///< [m]
  std::vector<double> radii;  ///< of the others, in their order
};

/// CrowdNav's ORCA policy: the velocity of `self` on the way to `goal`, at most its speed and 1 m/s, when everybody is
/// wider by 0.01 m + `safety_space`, and expected to share the avoiding; of the nearest `neighbours`.
Vector2 crowdnav_orca(const CrowdNavAgent& self, const Vector2& goal,
                      const std::vector<CrowdNavAgent>& others, double safety_space, std::size_t neighbours);

/// CrowdNav++'s social force: drawn to `goal`, pushed by everybody, as fast as `self` goes at most.
Vector2 crowdnav_social_force(const CrowdNavAgent& self, const Vector2& goal,
                              const std::vector<CrowdNavAgent>& others);

/// The people of a scene.
class CrowdNavPeople {
 public:
  explicit CrowdNavPeople(const CrowdNavScene& scene);

  const std::vector<CrowdNavAgent>& agents() const { return agents_; }

  /// What they decide now; `robot` is one of them if they see it. They go on walking round their goals.
  std::vector<Vector2> decide(const CrowdNavAgent* robot) const;

  /// Each walks `velocities` [m/s] for `duration` [s].
  void walk(const std::vector<Vector2>& velocities, double duration);

  /// What happens at `time` [s], at the end of a step: others come, goals change, with room for the robot and its goal.
  /// Who went.
  std::vector<CrowdNavAgent> renew(double time, const CrowdNavPerson& robot);

 private:
  CrowdNavPerson as_person(std::size_t i) const;
  std::vector<CrowdNavPerson> all(const CrowdNavPerson& robot) const;
  void meet();

  CrowdNavRules rules_;
  CrowdNavRandom random_;
  std::vector<CrowdNavAgent> agents_;
  std::vector<Vector2> goals_;
  std::vector<CrowdNavBelief> beliefs_;  ///< empty of who has just come
  std::uint32_t next_id_ = 0;
  double newest_look_ = 10.0;
};

}  // namespace bw
