// Rooms for measuring perception of people: drawn from a seed, with furniture that looks like legs, people
// who walk, or stand and shift their feet now and then, and a robot that stands or drives about with wheels
// that err.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/lab/people_training/furniture.hpp"
#include "components/model/random.hpp"
#include "components/world/ray.hpp"
#include "components/world/world.hpp"

namespace bw::people::test {

struct SceneOptions {
  int people = 6;
  double standing_share = 0.2;
  bool furnished = true;
  bool crowded = false;  ///< much more furniture: posts, tables with chairs, shelves, plants, trolleys
  bool driving = true;
  double laser_rate = 10.0;  ///< [Hz]
  int beams = 720;           ///< over 270 degrees
  bool front = false;        ///< the laser looks half a turn to the front
  bool rear = false;         ///< so does a second one to the rear
  bool camera = false;       ///< tells of whole people in front
  double length = 14.0;      ///< of the room [m]
  double width = 10.0;
};

struct Scene {
  WorldOptions options;
  WorldFiles files;
  Robot robot;
  std::vector<Vector2> positions;  ///< free of furniture, for the robot to go to
};

class SceneMaker {
 public:
  SceneMaker(const SceneOptions& options, std::uint64_t seed) : options_(options), random_(seed) {}

  Scene make() {
    Scene scene;
    room(scene);
    if (options_.crowded) {
      crowd_with_furniture(scene);
    } else if (options_.furnished) {
      furnish(scene);
    }
    place_people(scene);
    scene.options.laser.rate = options_.laser_rate;
    scene.options.laser.beams = options_.beams;
    scene.options.laser.range_noise = 0.02;
    scene.options.laser.range_max = 10.0;
    if (options_.front) scene.options.laser.field_of_view = std::numbers::pi;
    if (options_.rear) look_back(scene);
    scene.options.imu.rate = 0.0;
    scene.options.gps.rate = 0.0;
    scene.options.drive.mismatch = 0.004;
    scene.options.drive.noise = 0.00003;
    return scene;
  }

 private:
  Vector2 anywhere(double from_wall) {
    const double x = random_.uniform(from_wall, options_.length - from_wall);
    return {x, random_.uniform(from_wall, options_.width - from_wall)};
  }

  /// Each laser 0.2 m from the middle.
  static void look_back(Scene& scene) {
    LaserOptions& front = scene.options.laser;
    scene.robot.sensors = {{front.frame, 0.2, 0.0, 0.0}, {"laser_rear", -0.2, 0.0, std::numbers::pi}};
    MoreLaserOptions rear;
    static_cast<LaserOptions&>(rear) = front;
    rear.frame = "laser_rear";
    scene.options.more_lasers = {rear};
  }

  void room(Scene& scene) {
    const double l = options_.length;
    const double w = options_.width;
    scene.options.walls = {{0, 0, l, 0}, {l, 0, l, w}, {l, w, 0, w}, {0, w, 0, 0}};
    const Vector2 start = anywhere(2.0);
    scene.options.start = {start.x(), start.y(), random_.uniform(-3.1, 3.1)};
    keep_.push_back(start);
  }

  /// Somewhere at least `clearance` away from where the robot starts and from other furniture.
  Vector2 spot(double clearance) {
    for (int attempt = 0; attempt < 200; ++attempt) {
      const Vector2 position = anywhere(0.3);
      bool good = true;
      for (const Vector2& kept : keep_) good = good && (position - kept).norm() > clearance;
      if (good) return position;
    }
    return {0.3, 0.3};
  }

  void legs(Scene& scene, double length, double width, double radius) {
    const Vector2 position = spot(1.2);
    const Pose2 X{position.x(), position.y(), random_.uniform(-3.1, 3.1)};
    keep_.push_back(position);
    for (const double x : {-length / 2, length / 2})
      for (const double y : {-width / 2, width / 2})
        scene.files.shapes.discs.push_back({X * Vector2(x, y), radius});
  }

  void furnish(Scene& scene) {
    for (int i = 0; i < 4; ++i) {  // cupboards and boxes
      const Vector2 position = spot(1.4);
      keep_.push_back(position);
      scene.options.boxes.push_back({position.x(), position.y(), random_.uniform(0.2, 1.2),
                                     random_.uniform(0.2, 0.7), random_.uniform(-1.5, 1.5)});
    }
    for (int i = 0; i < 5; ++i) legs(scene, 0.42, 0.42, random_.uniform(0.012, 0.03));  // chairs
    for (int i = 0; i < 2; ++i)
      legs(scene, random_.uniform(0.8, 1.6), 0.8, random_.uniform(0.02, 0.05));  // tables
    for (int i = 0; i < 3; ++i) {                                                // pillars, plant pots
      const Vector2 position = spot(1.2);
      keep_.push_back(position);
      scene.files.shapes.discs.push_back({position, random_.uniform(0.1, 0.25)});
    }
  }

  void crowd_with_furniture(Scene& scene) {
    Furniture furniture;
    const auto stand = [&](Piece piece, int count, double clearance) {
      for (; count > 0; --count) furniture.add(piece, somewhere(clearance), random_);
    };
    for (int i = 0; i < 3; ++i) furniture.add_dining_table(somewhere(2.2), random_);
    stand(Piece::shelf, 2, 2.2);
    stand(Piece::box, 2, 1.4);
    stand(Piece::trolley, 2, 1.3);
    stand(Piece::chair, 3, 1.1);
    stand(Piece::pillar, 1, 1.1);
    stand(Piece::plant, 3, 1.0);
    stand(Piece::post, 6, 0.9);
    posts_in_a_row(furniture);
    scene.files.shapes = furniture.shapes();
  }

  Pose2 somewhere(double clearance) {
    const Vector2 position = spot(clearance);
    keep_.push_back(position);
    return {position.x(), position.y(), random_.uniform(-3.1, 3.1)};
  }

  /// Two to four alike, as far apart as legs or as a barrier's.
  void posts_in_a_row(Furniture& furniture) {
    for (int row = 0; row < 2; ++row) {
      const Pose2 X = somewhere(1.2);
      const double gap = row == 0 ? random_.uniform(0.2, 0.4) : random_.uniform(0.8, 1.2);
      const std::uint64_t make = random_.bits();
      for (int i = row == 0 ? 2 : 3; i > 0; --i) {
        Random alike(make);
        furniture.add(Piece::post, X * Pose2{gap * i, 0.0, 0.0}, alike);
      }
    }
  }

  void place_people(Scene& scene) {
    PeopleOptions& people = scene.options.people;
    people.social.speed_min = 0.5;
    people.social.speed_max = 1.4;
    people.social.forces.social_factor = 5.1;
    people.social.forces.obstacle_sigma = 0.3;
    people.legs.sway = 0.003;
    people.legs.shift_every = 15.0;
    for (int i = 0; i < options_.people; ++i) {
      const Vector2 start = spot(0.9);
      if (random_.uniform() < options_.standing_share) {
        ScriptedPersonOptions person;
        person.waypoints = {{start.x(), start.y()}};
        people.scripted.push_back(person);
        keep_.push_back(start);
        continue;
      }
      Vector2 goal = spot(0.7);
      for (int attempt = 0; attempt < 20 && (goal - start).norm() < 4.0; ++attempt) goal = spot(0.7);
      people.social.walkers.push_back({start.x(), start.y(), goal.x(), goal.y()});
    }
    for (int i = options_.crowded ? 40 : 12; i > 0; --i) scene.positions.push_back(spot(1.0));
  }

  SceneOptions options_;
  Random random_;
  std::vector<Vector2> keep_;
};

/// Drives from position to position where the way is clear of walls, furniture and people. Knows the truth:
/// what is measured is perception.
class Chauffeur {
 public:
  Chauffeur(const Scene& scene, std::uint64_t seed) : scene_(&scene), random_(seed) {}

  Twist2 command(const World& world) {
    const Pose2 X = world.pose();
    if (!going_ || (goal_ - X.position()).norm() < 0.3 || world.time() > until_) choose(world);
    if (!going_) return {0.0, 0.5};
    const Vector2 to_goal = goal_ - X.position();
    const double error = wrap_angle(std::atan2(to_goal.y(), to_goal.x()) - X.theta);
    const double omega = std::clamp(2.0 * error, -1.0, 1.0);
    const Vector2 ahead = X.position() + 0.8 * direction(X.theta);
    for (const Person& person : world.people())
      if ((person.position - ahead).norm() < 0.9) return {0.0, omega};
    return {std::abs(error) > 0.6 ? 0.0 : 0.8, omega};
  }

 private:
  void choose(const World& world) {
    going_ = false;
    for (int attempt = 0; attempt < 10 && !going_; ++attempt) {
      goal_ = scene_->positions[random_.bits() % scene_->positions.size()];
      going_ = (goal_ - world.pose().position()).norm() > 1.0 && clear(world);
    }
    until_ = world.time() + Duration::seconds(20.0);
  }

  bool clear(const World& world) const {
    const Vector2 from = world.pose().position();
    for (double share = 0.0; share <= 1.0; share += 0.05)
      if (world.scene().clearance(from + share * (goal_ - from), 0.45) < 0.4) return false;
    return true;
  }

  const Scene* scene_;
  Random random_;
  Vector2 goal_{0.0, 0.0};
  bool going_ = false;
  Duration until_;
};

}  // namespace bw::people::test
