// People of a training room: alone and in groups, walking and standing, each with legs of their own.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "components/model/random.hpp"
#include "components/world/legs.hpp"
#include "components/world/person.hpp"
#include "components/world/static_scene.hpp"

namespace bw::people {

struct TrainingPeopleOptions {
  int count = 0;
  bool restless = false;      ///< who stands sways, sets a foot aside now and then, and goes elsewhere
  bool varied_legs = true;    ///< else as usual in the world
  double laser_height = 0.3;  ///< above the floor, 0.1 to 0.5: ankles, calves, knees [m]
};

class TrainingPeople {
 public:
  /// `scene` must outlive the people. `free_position` draws somewhere to stand.
  TrainingPeople(const TrainingPeopleOptions& options, const StaticScene& scene,
                 const std::function<Vector2()>& free_position, Random& random);

  void step(double dt, const RobotBody& robot);

  const std::vector<Person>& people() const { return people_; }
  std::vector<Disc> legs() const;  ///< left, then right leg of each person

 private:
  std::vector<std::unique_ptr<PeopleModel>> groups_;
  std::vector<Person> people_;
  std::vector<Legs> legs_;  ///< by id, from 1
};

}  // namespace bw::people
