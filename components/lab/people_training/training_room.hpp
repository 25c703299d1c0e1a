// Rooms drawn from a seed, with everything in them that a detector of people meets: walls, furniture, people
// who walk and stand, a scanner that drives through. Frame M: the room.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "components/lab/people_training/furniture.hpp"
#include "components/lab/people_training/scanner_model.hpp"
#include "components/lab/people_training/training_people.hpp"
#include "components/people/detector/beams.hpp"
#include "components/world/static_scene.hpp"

namespace bw::people {

struct RoomOptions {
  int most_people = 20;
  bool furnished = true;
  bool crowded = false;        ///< with twice the furniture, and with posts in rows
  bool restless = false;       ///< who stands does not stand still
  bool varied_scanner = true;  ///< in any height; else the usual one, and legs as usual
  bool moving = true;          ///< the scanner drives
};

/// One sweep, and the truth behind it.
struct RoomSweep {
  Time time;
  Pose2 X_ML;                  ///< true pose of the scanner
  Pose2 X_OL;                  ///< as wheels that err a little (0.4 % between them) tell it
  LaserScan exact;             ///< without noise
  LaserScan scan;              ///< as measured
  std::vector<int> leg_of;     ///< by beam: index into `legs` of the one it meets; -1: none
  std::vector<Person> people;  ///< in M
  std::vector<Disc> legs;      ///< in M: left, then right leg of each person

  Pose2 X_MO() const { return X_ML * inverse(X_OL); }
};

class TrainingRoom {
 public:
  TrainingRoom(const RoomOptions& options, std::uint64_t seed);

  const RoomSweep& next();  ///< as often as the scanner rotates
  LaserSweep view() const;  ///< of the last one

  const Furniture& furniture() const { return furniture_; }
  double period() const { return 1.0 / scanner_model_.laser.rate; }  ///< between sweeps [s]

 private:
  void furnish();
  void stand_posts_in_rows();
  void find_legs();
  Vector2 free_position(double clearance);
  void drive(double dt);

  Random random_;
  double length_;
  double width_;
  bool moving_;
  Furniture furniture_;
  std::unique_ptr<StaticScene> scene_;
  ScannerModel scanner_model_;
  std::unique_ptr<LaserScanner> scanner_;
  std::unique_ptr<TrainingPeople> people_;
  Pose2 X_ML_;
  Pose2 X_OL_;
  Vector2 goal_{0.0, 0.0};
  RoomSweep sweep_;
};

}  // namespace bw::people
