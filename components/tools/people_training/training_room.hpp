// Rooms drawn from a seed, with everything in them that a detector of people meets: walls, boxes, pillars,
// legs of chairs and tables, people who walk and stand, a scanner that drives through. Frame M: the room.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "components/people/detector/beams.hpp"
#include "components/world/laser_scanner.hpp"
#include "components/world/legs.hpp"
#include "components/world/person.hpp"
#include "components/world/static_scene.hpp"

namespace bw::people {

struct RoomOptions {
  int most_people = 20;
  bool furnished = true;
  bool varied_scanner = true;  ///< else 720 beams over 270 degrees, noise 0.02 m, 10 m; legs as usual
  bool moving = true;          ///< the scanner drives
};

/// One sweep, and the truth behind it.
struct RoomSweep {
  Time time;
  Pose2 X_ML;  ///< true pose of the scanner
  Pose2 X_OL;  ///< as wheels that err a little (0.4 % between them) tell it
  LaserScan scan;
  std::vector<Person> people;  ///< in M
  std::vector<Disc> legs;      ///< in M: left, then right leg of each person

  Pose2 X_MO() const { return X_ML * inverse(X_OL); }
};

class TrainingRoom {
 public:
  TrainingRoom(const RoomOptions& options, std::uint64_t seed);

  const RoomSweep& next();  ///< ten per second
  LaserSweep view() const;  ///< of the last one

  const StaticScene& scene() const { return *scene_; }
  const LaserOptions& laser() const { return laser_options_; }

 private:
  void furnish(StaticObstacles& shapes);
  void people(const RoomOptions& options);
  Vector2 free_place(double clearance);
  void drive(double dt);

  Random random_;
  double length_;
  double width_;
  bool moving_;
  std::unique_ptr<StaticScene> scene_;
  LaserOptions laser_options_;
  std::unique_ptr<LaserScanner> scanner_;
  std::unique_ptr<Legs> legs_;
  std::vector<std::unique_ptr<PeopleModel>> groups_;
  Pose2 X_ML_;
  Pose2 X_OL_;
  Vector2 goal_{0.0, 0.0};
  RoomSweep sweep_;
};

}  // namespace bw::people
