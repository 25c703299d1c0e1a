// People who walk to goals by the social force model: among each other, along walls, and round the robot if
// they see it, and with their group.
#pragma once

#include <optional>
#include <vector>

#include "components/model/random.hpp"
#include "components/model/social_force.hpp"
#include "components/world/admission.hpp"
#include "components/world/goal_walker.hpp"
#include "components/world/person.hpp"
#include "components/world/static_scene.hpp"

namespace bw {

struct SocialWalkersOptions : GoalWalkersOptions {
  SocialForceOptions forces;

  template <class Visitor>
  void fields(Visitor& v) {
    GoalWalkersOptions::fields(v);
    v("forces", forces, {.doc = "constants of the social force model"});
  }
};

class SocialWalkers final : public PeopleModel {
 public:
  /// `scene` must outlive the walkers. Ids count up from `first_id`.
  SocialWalkers(const SocialWalkersOptions& options, const StaticScene& scene, std::uint32_t first_id,
                Random random);
  void step(double dt, const Surroundings& surroundings, std::vector<Person>& people) override;
  bool displace(std::uint32_t id, const Vector2& by) override;
  /// One more. Who has a goal walks there, and on as the others do (turn_round); who has none keeps to the
  /// velocity.
  void add(std::uint32_t id, const NewPerson& person);

 private:
  struct Walker : GoalWalker {
    std::optional<Vector2> course = std::nullopt;  ///< the velocity that somebody without a goal wants
  };

  Vector2 pull_of_group(const Walker& walker) const;
  Vector2 force_on(const Walker& walker, const Surroundings& surroundings) const;

  SocialWalkersOptions options_;
  const StaticScene& scene_;
  double wall_reach_;  ///< farther than this from their rim [m] a wall's push is below kNegligible
  std::vector<Walker> walkers_;
  std::vector<Vector2> forces_;
};

}  // namespace bw
