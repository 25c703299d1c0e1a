// Everybody and everything in a crowd scene, from instant to instant: walkers who go straight on, and walkers
// who react, by the models of the world (components/world). Metres, seconds.
//
// Who reacts starts where the scene says, at rest; walks to and fro between there and a goal that is drawn in
// the box, at least 4 m away and free of static discs; wants a speed drawn uniform in [0.3, 1.2]; sees the
// others, the static discs and the robot. The draws depend on the scene's name alone. Nobody is held inside
// of the box, and the model's options have their defaults.
#pragma once

#include <memory>
#include <vector>

#include "components/lab/bench/scene_file.hpp"
#include "components/world/person.hpp"
#include "components/world/static_scene.hpp"

namespace bw {

class CrowdPeople {
 public:
  /// `scene` must outlive it.
  CrowdPeople(const Scene& scene, const ClosedLoop& rule);

  /// Goes on to `time` [s] after the scene began; times rise. `robot`: as those see it who react.
  void move_to(double time, const Pose2& robot, const Twist2& twist);

  /// Of obstacle `i` of the scene, now.
  Vector2 position(std::size_t i) const;
  Vector2 velocity(std::size_t i) const;
  /// Someone who may move; false: a static disc.
  bool walks(std::size_t i) const { return scene_.obstacles[i].moves(); }

 private:
  const Scene& scene_;
  ClosedLoop rule_;
  double time_ = 0.0;
  StaticScene statics_;
  std::unique_ptr<PeopleModel> model_;  ///< nothing: they go straight on
  std::vector<Person> people_;          ///< by the model
  const std::vector<Person> nobody_else_;
  std::vector<std::size_t> person_of_;  ///< by obstacle
};

}  // namespace bw
