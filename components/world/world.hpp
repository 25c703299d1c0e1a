// The world simulated robots live in: floor, walls, people, and the sensors and wheels of the robots, one
// unless the options name several. It knows no middleware, clock or file: it is stepped, and the same seed
// and commands give the same bytes.
//
// One step of kPhysicsStep: the wheels follow the held commands, the poses their exact arcs, people move
// (each group sees the groups before it), contacts are counted, and the sensors that are due read the new
// state.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "components/model/occupancy_grid.hpp"
#include "components/model/robot.hpp"
#include "components/world/admission.hpp"
#include "components/world/contact_log.hpp"
#include "components/world/push.hpp"
#include "components/world/world_options.hpp"

namespace bw {

/// What a world takes from files; each part may be empty.
struct WorldFiles {
  std::optional<OccupancyGrid> map;  ///< in map
  std::vector<Track> tracks;         ///< recorded people, in the frame of the recording
  StaticObstacles shapes;            ///< the recording's walls and pillars, in its frame
};

/// What the step produced for one robot. Only what is due is there.
struct WorldSample {
  Duration time;  ///< since the start of the world
  std::optional<EncoderTicks> ticks;
  std::optional<LaserScan> scan;
  std::vector<std::optional<LaserScan>> more_scans;  ///< as WorldOptions::more_lasers
  std::optional<ImuReading> imu;
  std::vector<GpsFix> fixes;
  bool truth_due = false;
};

class World {
 public:
  /// Throws std::runtime_error when the parts do not make a world: a map whose sizes disagree, a person
  /// without a position, a robot that starts inside a wall or another robot.
  World(const WorldOptions& options, const Robot& robot, const WorldFiles& files, std::uint64_t seed);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Wheel rates held until the next command. False, and the base brakes, when they are not finite.
  bool command(const WheelCommand& command, std::size_t robot = 0) {
    return robots_[robot].drive.command(command);
  }

  /// Who they are from now on, or why they may not come.
  struct Admission {
    std::uint32_t id = 0;
    std::string refusal;  ///< one sentence; empty: they are there
  };
  /// One more person, who walks by the social force model, as of this instant.
  Admission add_person(const NewPerson& person);
  /// Changes the velocity of a walker or scripted person at once; what was added decays, and ends at a wall.
  /// One sentence when it may not be.
  std::string push_person(std::uint32_t id, const Vector2& velocity_change);

  /// What it produced for the first robot; samples() has it for all. Both until the next step.
  const WorldSample& step();
  const std::vector<WorldSample>& samples() const { return samples_; }

  Duration time() const { return step_ * steps_; }
  Duration physics_step() const { return step_; }
  std::size_t robot_count() const { return robots_.size(); }
  const Pose2& pose(std::size_t robot = 0) const {
    return robots_[robot].drive.pose();
  }  ///< true, of base_link in map
  Twist2 twist(std::size_t robot = 0) const { return robots_[robot].drive.twist(); }  ///< true body velocity
  const std::vector<Person>& people() const { return people_; }
  /// Everybody a robot may meet: people, then the other robots with ids from kFirstRobotId on.
  std::vector<Person> others(std::size_t robot) const;
  const ContactLog& contacts(std::size_t robot = 0) const { return robots_[robot].contacts; }
  const Footprint& footprint(std::size_t robot = 0) const { return robots_[robot].drive.footprint(); }
  /// The robot's outline from now on.
  void set_footprint(const Footprint& footprint, std::size_t robot = 0) {
    robots_[robot].drive.set_footprint(footprint);
  }
  /// From the robot's rim to the nearest wall, at most `limit` [m].
  double wall_gap(double limit, std::size_t robot = 0) const;
  const StaticScene& scene() const { return scene_; }

 private:
  struct SimulatedRobot {
    DriveModel drive;
    LaserScanner laser;
    std::vector<LaserScanner> more_lasers;
    Imu imu;
    Gps gps;
    ContactLog contacts;
  };

  void add_robot(const StartOptions& start, std::uint64_t seed);
  bool due(double rate) const;
  std::uint32_t first_free_id(const std::vector<Track>& tracks) const;
  void move_people(double dt);
  void move_pushed(double dt);
  RobotBody body(std::size_t robot) const;
  void read_sensors(std::size_t robot, WorldSample& sample);
  std::vector<Disc> movers_about(std::size_t robot) const;

  WorldOptions options_;
  Robot robot_;
  Duration step_;
  std::int64_t steps_ = 0;
  StaticScene scene_;
  Pose2 X_base_laser_;
  std::vector<Pose2> X_base_more_;  ///< of more_lasers
  std::vector<SimulatedRobot> robots_;
  std::vector<WorldSample> samples_;  ///< of the last step, one for each robot
  Legs legs_;
  std::vector<std::unique_ptr<PeopleModel>> groups_;
  SocialWalkers* walkers_ = nullptr;  ///< the group that others may join
  std::uint32_t next_id_ = 1;         ///< of who joins
  std::map<std::uint32_t, Push> pushes_;
  std::vector<Person> people_;
};

}  // namespace bw
