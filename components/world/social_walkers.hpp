// People who walk to goals by the social force model: among each other, along walls, and round the robot if
// they see it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/model/random.hpp"
#include "components/model/social_force.hpp"
#include "components/world/admission.hpp"
#include "components/world/goal_walker.hpp"
#include "components/world/person.hpp"
#include "components/world/static_scene.hpp"

namespace bw {

struct WalkerOptions {
  double x = 0.0;
  double y = 0.0;
  double goal_x = 0.0;
  double goal_y = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "start, in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "start, in map"});
    v("goal_x", goal_x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "goal, in map"});
    v("goal_y", goal_y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "goal, in map"});
  }
};

struct SocialWalkersOptions {
  std::vector<WalkerOptions> walkers;
  double speed_min = 1.0;
  double speed_max = 1.3;
  double start_jitter = 0.0;
  bool turn_round = true;
  double goal_tolerance = 0.5;
  double radius = 0.3;
  SocialForceOptions forces;

  template <class Visitor>
  void fields(Visitor& v) {
    v("walkers", walkers, {.doc = "one person each"});
    v("speed_min", speed_min,
      {.unit = "m/s",
       .min = 0,
       .max = 5,
       .doc = "least of the desired speeds, one of which is drawn for each walker"});
    v("speed_max", speed_max, {.unit = "m/s", .min = 0, .max = 5, .doc = "largest of the desired speeds"});
    v("start_jitter", start_jitter,
      {.unit = "m", .min = 0, .max = 10, .doc = "starts are moved by up to this in x and y"});
    v("turn_round", turn_round, {.doc = "at the goal walk back to the start, to and fro; else stand there"});
    v("goal_tolerance", goal_tolerance,
      {.unit = "m", .min = 0.05, .max = 10, .doc = "nearer than this the goal is reached"});
    v("radius", radius,
      {.unit = "m", .min = 0.05, .max = 2, .doc = "radius of the disc that counts as contact"});
    v("forces", forces, {.doc = "constants of the social force model"});
  }

  std::optional<std::string> violated_rule() const {
    if (speed_max < speed_min) return "speed_max must be at least speed_min";
    return std::nullopt;
  }
};

class SocialWalkers final : public PeopleModel {
 public:
  /// `scene` must outlive the walkers. Ids count up from `first_id`.
  SocialWalkers(const SocialWalkersOptions& options, const StaticScene& scene, std::uint32_t first_id,
                Random random);
  void step(double dt, const Surroundings& surroundings, std::vector<Person>& people) override;
  bool displace(std::uint32_t id, const Vector2& by) override;
  /// One more. Who has a goal walks there, and on as the others do (turn_round); who has none keeps to the velocity.
  void add(std::uint32_t id, const NewPerson& person);

 private:
  struct Walker : GoalWalker {
    std::optional<Vector2> course = std::nullopt;  ///< the velocity that somebody without a goal wants
  };

  Vector2 force_on(const Walker& walker, const Surroundings& surroundings) const;

  SocialWalkersOptions options_;
  const StaticScene& scene_;
  double wall_reach_;  ///< farther than this from their rim [m] a wall's push is below kNegligible
  std::vector<Walker> walkers_;
  std::vector<Vector2> forces_;
};

}  // namespace bw
