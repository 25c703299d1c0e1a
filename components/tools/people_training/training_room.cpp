#include "components/tools/people_training/training_room.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "components/world/scripted_people.hpp"
#include "components/world/social_walkers.hpp"

namespace bw::people {
namespace {

constexpr double kPeriod = 0.1;       // between sweeps [s]
constexpr double kStep = 0.02;        // of the people's motion [s]
constexpr double kSpeed = 0.7;        // of the scanner [m/s]
constexpr double kTurnRate = 0.8;     // [rad/s]
constexpr double kMismatch = 0.004;   // of the wheels
constexpr double kSeparation = 0.39;  // of the wheels [m]
constexpr double kPi = std::numbers::pi;

int count_up_to(Random& random, int most) { return static_cast<int>(random.uniform() * (most + 1)); }

void add_box(const Pose2& X_MB, double length, double width, StaticObstacles& shapes) {
  const std::array<Vector2, 4> corners = {
      X_MB * Vector2(length / 2, width / 2), X_MB * Vector2(-length / 2, width / 2),
      X_MB * Vector2(-length / 2, -width / 2), X_MB * Vector2(length / 2, -width / 2)};
  for (std::size_t i = 0; i < 4; ++i) shapes.segments.push_back({corners[i], corners[(i + 1) % 4]});
}

void add_four_legs(const Pose2& X_MB, double length, double width, double radius, StaticObstacles& shapes) {
  for (const double x : {-length / 2, length / 2}) {
    for (const double y : {-width / 2, width / 2}) shapes.discs.push_back({X_MB * Vector2(x, y), radius});
  }
}

LaserOptions draw_laser(Random& random, bool varied) {
  struct Model {
    int beams;
    double field_of_view;
    double range_max;
  };
  // As sold: 0.375, 0.25, 0.36, 0.5 and 1 degree between beams.
  constexpr std::array<Model, 6> kModels = {{{720, 1.5 * kPi, 10.0},
                                             {720, 1.5 * kPi, 20.0},
                                             {1080, 1.5 * kPi, 30.0},
                                             {512, kPi, 5.6},
                                             {541, 1.5 * kPi, 20.0},
                                             {360, 2.0 * kPi * 359.0 / 360.0, 12.0}}};
  LaserOptions options;
  const double pick = random.uniform();
  const double noise = random.uniform(0.004, 0.03);
  const Model& model = kModels[varied ? static_cast<std::size_t>(pick * kModels.size()) : 0];
  options.beams = model.beams;
  options.field_of_view = model.field_of_view;
  options.range_max = model.range_max;
  options.range_noise = varied ? noise : 0.02;
  return options;
}

bw::LegOptions draw_legs(Random& random, bool varied) {
  bw::LegOptions legs;
  // Shins; and ankles in every third room: real scanners near the floor see 0.06 to 0.1 m of them.
  const double radius = random.uniform() < 0.33 ? random.uniform(0.025, 0.055) : random.uniform(0.055, 0.09);
  const double separation = random.uniform(0.16, 0.3);
  const double swing = random.uniform(0.12, 0.22);
  if (!varied) return legs;
  legs.radius = radius;
  legs.separation = separation;
  legs.swing = swing;
  return legs;
}

}  // namespace

TrainingRoom::TrainingRoom(const RoomOptions& options, std::uint64_t seed)
    : random_(seed),
      length_(random_.uniform(7.0, 18.0)),
      width_(random_.uniform(6.0, 12.0)),
      moving_(options.moving) {
  StaticObstacles shapes;
  add_box({length_ / 2, width_ / 2, 0.0}, length_, width_, shapes);
  if (options.furnished) furnish(shapes);
  scene_ = std::make_unique<StaticScene>(std::move(shapes), std::nullopt);
  laser_options_ = draw_laser(random_, options.varied_scanner);
  scanner_ = std::make_unique<LaserScanner>(laser_options_, Random(random_.bits()));
  legs_ = std::make_unique<Legs>(draw_legs(random_, options.varied_scanner));
  people(options);
  const Vector2 start = free_place(0.4);
  X_ML_ = {start.x(), start.y(), random_.uniform(-kPi, kPi)};
  X_OL_ = {random_.uniform(-5.0, 5.0), random_.uniform(-5.0, 5.0), random_.uniform(-kPi, kPi)};
  goal_ = free_place(0.4);
}

void TrainingRoom::furnish(StaticObstacles& shapes) {
  const auto somewhere = [&] {
    return Pose2{random_.uniform(0.0, length_), random_.uniform(0.0, width_), random_.uniform(-kPi, kPi)};
  };
  for (int n = count_up_to(random_, 2); n > 0; --n) {
    const Pose2 X = somewhere();
    shapes.segments.push_back({X.position(), X * Vector2(random_.uniform(0.5, 3.0), 0.0)});
  }
  for (int n = count_up_to(random_, 5); n > 0; --n) {
    const Pose2 X = somewhere();
    const double length = random_.uniform(0.15, 1.2);
    add_box(X, length, random_.uniform(0.15, 0.8), shapes);
  }
  for (int n = count_up_to(random_, 3); n > 0; --n)
    shapes.discs.push_back({somewhere().position(), random_.uniform(0.1, 0.3)});
  for (int n = count_up_to(random_, 2); n > 0; --n)  // pots and bins
    shapes.discs.push_back({somewhere().position(), random_.uniform(0.05, 0.15)});
  for (int n = count_up_to(random_, 6); n > 0; --n) {  // chairs
    const Pose2 X = somewhere();
    const double side = random_.uniform(0.33, 0.5);
    add_four_legs(X, side, side, random_.uniform(0.01, 0.03), shapes);
  }
  for (int n = count_up_to(random_, 3); n > 0; --n) {  // tables
    const Pose2 X = somewhere();
    const double length = random_.uniform(0.7, 1.8);
    add_four_legs(X, length, random_.uniform(0.6, 0.9), random_.uniform(0.02, 0.05), shapes);
  }
}

void TrainingRoom::people(const RoomOptions& options) {
  const int count = options.most_people > 0 ? 1 + count_up_to(random_, options.most_people - 1) : 0;
  SocialWalkersOptions walkers;
  walkers.speed_min = 0.4;
  walkers.speed_max = 1.6;
  walkers.forces.social_factor = 5.1;
  std::vector<ScriptedPersonOptions> standing;
  for (int i = 0; i < count; ++i) {
    const Vector2 start = free_place(0.35);
    const Vector2 goal = free_place(0.35);
    if (random_.uniform() < 0.25) {
      ScriptedPersonOptions person;
      person.waypoints = {{start.x(), start.y()}};
      standing.push_back(person);
    } else {
      walkers.walkers.push_back({start.x(), start.y(), goal.x(), goal.y()});
    }
  }
  const auto first_walker = static_cast<std::uint32_t>(standing.size() + 1);
  groups_.push_back(std::make_unique<ScriptedPeople>(std::move(standing), 1));
  groups_.push_back(std::make_unique<SocialWalkers>(walkers, *scene_, first_walker, Random(random_.bits())));
}

Vector2 TrainingRoom::free_place(double clearance) {
  Vector2 place{length_ / 2, width_ / 2};
  for (int attempt = 0; attempt < 200; ++attempt) {
    place = {random_.uniform(0.4, length_ - 0.4), random_.uniform(0.4, width_ - 0.4)};
    if (scene_->clearance(place, 1.0) > clearance) break;
  }
  return place;
}

void TrainingRoom::drive(double dt) {
  if (!moving_) return;
  const Vector2 to_goal = goal_ - X_ML_.position();
  if (to_goal.norm() < 0.3) {
    goal_ = free_place(0.4);
    return;
  }
  const double error = wrap_angle(std::atan2(to_goal.y(), to_goal.x()) - X_ML_.theta);
  const double turn = std::clamp(error, -kTurnRate * dt, kTurnRate * dt);
  const double way = std::abs(error) < 0.5 ? kSpeed * dt : 0.0;
  X_ML_ = X_ML_ * Pose2{way * std::cos(turn / 2), way * std::sin(turn / 2), turn};
  const double believed = turn + kMismatch * way / kSeparation;
  X_OL_ = X_OL_ * Pose2{way * std::cos(believed / 2), way * std::sin(believed / 2), believed};
}

const RoomSweep& TrainingRoom::next() {
  std::vector<Person> present;
  for (double t = 0.0; t < kPeriod - 1e-9; t += kStep) {
    drive(kStep);
    const RobotBody robot{X_ML_.position(), {0.0, 0.0}, 0.3};
    present.clear();
    for (const auto& group : groups_) {
      const std::vector<Person> before = present;
      group->step(kStep, {before, {&robot, 1}}, present);
    }
    legs_->step(kStep, present);
  }
  sweep_.time = sweep_.time + Duration::seconds(kPeriod);
  sweep_.X_ML = X_ML_;
  sweep_.X_OL = X_OL_;
  sweep_.legs = legs_->discs(present);
  sweep_.people = std::move(present);
  sweep_.scan = scanner_->scan(*scene_, sweep_.legs, X_ML_);
  return sweep_;
}

LaserSweep TrainingRoom::view() const {
  return {sweep_.time,
          sweep_.X_OL,
          sweep_.scan.angle_min,
          sweep_.scan.angle_increment,
          laser_options_.range_min,
          laser_options_.range_max,
          sweep_.scan.ranges};
}

}  // namespace bw::people
