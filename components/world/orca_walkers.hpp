// People who walk to goals by ORCA (orca/theory.md 5.6): each does half of the avoiding and trusts the others
// of them to do the rest.
#pragma once

#include <cstdint>
#include <vector>

#include "components/model/random.hpp"
#include "components/world/goal_walker.hpp"
#include "components/world/person.hpp"
#include "components/world/static_scene.hpp"

namespace bw {

struct OrcaWalkersOptions : GoalWalkersOptions {
  /// [m] kept beyond the radius, by each
  static constexpr double kMargin = 0.01;
  /// [m] who is further away is not looked at
  static constexpr double kNeighbourRange = 10.0;
  /// nearest others looked at
  static constexpr std::int64_t kMaxNeighbours = 10;
  /// [s] they keep clear of others for so long
  static constexpr double kHorizon = 5.0;
  /// [s] they keep clear of walls for so long
  static constexpr double kWallHorizon = 1.0;
  /// [s] between two decisions, in which they keep velocity
  static constexpr double kPeriod = 0.1;
  /// robots that they see (people_react) are trusted to do half of the avoiding; false: walkers do all
  /// (set by code alone)
  bool robots_share = true;

  template <class Visitor>
  void fields(Visitor& v) {
    GoalWalkersOptions::fields(v);
    v.retired(
      {"margin", "neighbour_range", "max_neighbours", "horizon", "wall_horizon", "period", "robots_share"},
      "a constant of orca_walkers.hpp");
  }
};

class OrcaWalkers final : public PeopleModel {
 public:
  /// `scene` must outlive the walkers. Ids count up from `first_id`.
  OrcaWalkers(const OrcaWalkersOptions& options, const StaticScene& scene, std::uint32_t first_id,
              Random random);
  void step(double dt, const Surroundings& surroundings, std::vector<Person>& people) override;
  bool displace(std::uint32_t id, const Vector2& by) override;

 private:
  Vector2 decision_of(const GoalWalker& walker, const Surroundings& surroundings) const;
  void decide(const Surroundings& surroundings);

  OrcaWalkersOptions options_;
  const StaticScene& scene_;
  std::vector<GoalWalker> walkers_;
  double until_decision_ = 0.0;  ///< [s]
};

}  // namespace bw
