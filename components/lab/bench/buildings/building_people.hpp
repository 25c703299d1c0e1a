// People who walk about a building: to a place drawn from all that can be reached, by a short way there, then
// they stand for a moment or for a minute, and on to the next. Frame: map.
//
// They step aside for the robot, which does not wait for them: its drive is the same with and without them.
// Where there is no room to step aside, such as in a door, they are not there while it passes.
#pragma once

#include <vector>

#include "components/lab/bench/buildings/building.hpp"
#include "components/lab/bench/buildings/walkable_cells.hpp"
#include "components/lab/bench/buildings/wall_index.hpp"
#include "components/model/random.hpp"
#include "components/world/legs.hpp"

namespace bw::buildings {

class BuildingPeople {
 public:
  /// `walls` are those of the building, and live as long.
  BuildingPeople(const Building& building, const WallIndex& walls, int count, Random random);

  /// Moves everybody by dt [s] while the robot is at `robot`.
  void step(double dt, const Vector2& robot);
  /// Those who are there.
  const std::vector<Person>& people() const { return people_; }
  std::vector<Disc> legs() const { return legs_.discs(people_); }

 private:
  struct Walker {
    Person body;
    double speed = 1.0;        ///< [m/s]
    std::vector<Vector2> way;  ///< corners still to go, the next one last
    double stands = 0.0;       ///< for so long still [s]
  };

  Vector2 walked(Walker& walker, double dt);
  /// False where it has no room beside the robot.
  bool move(Walker& walker, double dt, const Vector2& robot);
  bool has_room(const Vector2& place) const;

  const WallIndex& walls_;
  WalkableCells cells_;
  Random random_;
  Legs legs_;
  std::vector<Walker> walkers_;
  std::vector<Person> people_;
};

}  // namespace bw::buildings
