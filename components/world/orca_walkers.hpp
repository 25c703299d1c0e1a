// People who walk to goals by ORCA (book 5.6): each does half of the avoiding and trusts the others of them to do the rest.
#pragma once

#include <cstdint>
#include <vector>

#include "components/model/random.hpp"
#include "components/world/goal_walker.hpp"
#include "components/world/person.hpp"
#include "components/world/static_scene.hpp"

namespace bw {

struct OrcaWalkersOptions : GoalWalkersOptions {
  double margin = 0.01;
  double neighbour_range = 10.0;
  std::int64_t max_neighbours = 10;
  double horizon = 5.0;
  double wall_horizon = 1.0;
  double period = 0.1;
  bool robots_share = true;

  template <class Visitor>
  void fields(Visitor& v) {
    GoalWalkersOptions::fields(v);
    v("margin", margin, {.unit = "m", .min = 0, .max = 2, .doc = "kept beyond the radius, by each"});
    v("neighbour_range", neighbour_range,
      {.unit = "m", .min = 0.1, .max = 100, .doc = "who is further away is not looked at"});
    v("max_neighbours", max_neighbours, {.min = 1, .max = 100, .doc = "nearest others looked at"});
    v("horizon", horizon,
      {.unit = "s",
       .min = 0.1,
       .max = 60,
       .doc = "they keep clear of others for so long; longer avoids earlier"});
    v("wall_horizon", wall_horizon,
      {.unit = "s", .min = 0.1, .max = 60, .doc = "they keep clear of walls for so long"});
    v("period", period,
      {.unit = "s", .min = 0.01, .max = 2, .doc = "between two decisions, in which they keep velocity"});
    v("robots_share", robots_share,
      {.doc =
           "robots that they see (people_react) are trusted to do half of the avoiding; false: walkers do all"});
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
