// The world a simulated robot lives in: floor, walls, people, and the sensors and wheels of the robot. It
// knows no middleware, clock or file: it is stepped, and the same seed and commands give the same bytes.
//
// One step of physics_step: the wheels follow the held command, the pose its exact arc, people move (each
// group sees the groups before it), contacts are counted, and the sensors that are due read the new state.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "components/model/occupancy_grid.hpp"
#include "components/model/robot.hpp"
#include "components/world/contact_log.hpp"
#include "components/world/world_options.hpp"

namespace bw {

/// What a world takes from files; each part may be empty.
struct WorldFiles {
  std::optional<OccupancyGrid> map;  ///< in map
  std::vector<Track> tracks;         ///< recorded people, in the frame of the recording
  StaticObstacles shapes;            ///< the recording's walls and pillars, in its frame
};

/// What the step produced. Only what is due is there.
struct WorldSample {
  Duration time;  ///< since the start of the world
  std::optional<EncoderTicks> ticks;
  std::optional<LaserScan> scan;
  std::optional<ImuReading> imu;
  std::vector<GpsFix> fixes;
  bool truth_due = false;
};

class World {
 public:
  /// Throws std::runtime_error when the parts do not make a world: a map whose sizes disagree, a person
  /// without a place, a robot that starts inside a wall.
  World(const WorldOptions& options, const Robot& robot, const WorldFiles& files, std::uint64_t seed);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Wheel rates held until the next command. False, and the base brakes, when they are not finite.
  bool command(const WheelCommand& command) { return drive_.command(command); }

  WorldSample step();

  Duration time() const { return step_ * steps_; }
  Duration physics_step() const { return step_; }
  const Pose2& pose() const { return drive_.pose(); }  ///< true, of base_link in map
  Twist2 twist() const { return drive_.twist(); }      ///< true body velocity
  const std::vector<Person>& people() const { return people_; }
  const ContactLog& contacts() const { return contacts_; }
  double wall_gap(double limit) const;  ///< from the robot's rim to the nearest wall, at most `limit` [m]
  const StaticScene& scene() const { return scene_; }

 private:
  bool due(double rate) const;
  void move_people(double dt);
  RobotBody robot_body() const;

  WorldOptions options_;
  Robot robot_;
  Duration step_;
  std::int64_t steps_ = 0;
  StaticScene scene_;
  DriveModel drive_;
  Pose2 X_base_laser_;
  LaserScanner laser_;
  Imu imu_;
  Gps gps_;
  Legs legs_;
  std::vector<std::unique_ptr<PeopleModel>> groups_;
  std::vector<Person> people_;
  ContactLog contacts_;
};

}  // namespace bw
