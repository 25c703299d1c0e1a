#include "components/lab/people_training/training_room.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/world/ray.hpp"

namespace bw::people {
namespace {

constexpr double kLongestStep = 0.02;  // of the people's motion [s]
constexpr double kSpeed = 0.7;         // of the scanner [m/s]
constexpr double kTurnRate = 0.8;      // [rad/s]
constexpr double kMismatch = 0.004;    // of the wheels
constexpr double kSeparation = 0.39;   // of the wheels [m]

int count_up_to(Random& random, int most) { return static_cast<int>(random.uniform() * (most + 1)); }

}  // namespace

TrainingRoom::TrainingRoom(const RoomOptions& options, std::uint64_t seed)
    : random_(seed),
      length_(random_.uniform(7.0, 18.0)),
      width_(random_.uniform(6.0, 12.0)),
      moving_(options.moving) {
  furniture_.add_box(Piece::wall, {length_ / 2, width_ / 2, 0.0}, length_, width_);
  if (options.furnished) furnish();
  if (options.crowded) {
    furnish();
    stand_posts_in_rows();
  }
  scene_ = std::make_unique<StaticScene>(furniture_.shapes(), std::nullopt);
  scanner_model_ = draw_scanner(random_, options.varied_scanner);
  scanner_ = std::make_unique<LaserScanner>(scanner_model_.laser, Random(random_.bits()));
  const TrainingPeopleOptions people{
      .count = options.most_people > 0 ? 1 + count_up_to(random_, options.most_people - 1) : 0,
      .restless = options.restless,
      .varied_legs = options.varied_scanner,
      .laser_height = random_.uniform(0.1, 0.5)};
  people_ = std::make_unique<TrainingPeople>(
      people, *scene_, [this] { return free_position(0.35); }, random_);
  const Vector2 start = free_position(0.4);
  X_ML_ = {start.x(), start.y(), random_.uniform(-std::numbers::pi, std::numbers::pi)};
  X_OL_ = {random_.uniform(-5.0, 5.0), random_.uniform(-5.0, 5.0),
           random_.uniform(-std::numbers::pi, std::numbers::pi)};
  goal_ = free_position(0.4);
}

void TrainingRoom::furnish() {
  const auto somewhere = [&] {
    return Pose2{random_.uniform(0.0, length_), random_.uniform(0.0, width_),
                 random_.uniform(-std::numbers::pi, std::numbers::pi)};
  };
  const auto stand_up_to = [&](int most, Piece piece) {
    for (int n = count_up_to(random_, most); n > 0; --n) furniture_.add(piece, somewhere(), random_);
  };
  stand_up_to(2, Piece::wall);
  stand_up_to(4, Piece::box);
  stand_up_to(3, Piece::pillar);
  stand_up_to(6, Piece::post);
  stand_up_to(5, Piece::chair);
  stand_up_to(2, Piece::table);
  stand_up_to(2, Piece::shelf);
  stand_up_to(4, Piece::plant);
  stand_up_to(3, Piece::trolley);
  for (int n = count_up_to(random_, 2); n > 0; --n) furniture_.add_dining_table(somewhere(), random_);
}

/// Two or more alike, as far apart as legs or as a barrier's.
void TrainingRoom::stand_posts_in_rows() {
  for (int row = count_up_to(random_, 4); row > 0; --row) {
    const Pose2 X{random_.uniform(0.0, length_), random_.uniform(0.0, width_),
                  random_.uniform(-std::numbers::pi, std::numbers::pi)};
    const double gap = random_.uniform() < 0.6 ? random_.uniform(0.15, 0.45) : random_.uniform(0.6, 1.4);
    const std::uint64_t make = random_.bits();
    for (int i = 2 + count_up_to(random_, 2); i > 0; --i) {
      Random alike(make);
      furniture_.add(Piece::post, X * Pose2{gap * i, 0.0, 0.0}, alike);
    }
  }
}

Vector2 TrainingRoom::free_position(double clearance) {
  Vector2 position{length_ / 2, width_ / 2};
  for (int attempt = 0; attempt < 200; ++attempt) {
    position = {random_.uniform(0.4, length_ - 0.4), random_.uniform(0.4, width_ - 0.4)};
    if (scene_->clearance(position, 1.0) > clearance) break;
  }
  return position;
}

void TrainingRoom::drive(double dt) {
  if (!moving_) return;
  const Vector2 to_goal = goal_ - X_ML_.position();
  if (to_goal.norm() < 0.3) {
    goal_ = free_position(0.4);
    return;
  }
  const double error = wrap_angle(std::atan2(to_goal.y(), to_goal.x()) - X_ML_.theta);
  const double rotation = std::clamp(error, -kTurnRate * dt, kTurnRate * dt);
  const double distance = std::abs(error) < 0.5 ? kSpeed * dt : 0.0;
  X_ML_ = X_ML_ * Pose2{distance * std::cos(rotation / 2), distance * std::sin(rotation / 2), rotation};
  const double believed = rotation + kMismatch * distance / kSeparation;
  X_OL_ = X_OL_ * Pose2{distance * std::cos(believed / 2), distance * std::sin(believed / 2), believed};
}

const RoomSweep& TrainingRoom::next() {
  const int steps = static_cast<int>(std::ceil(period() / kLongestStep - 1e-9));
  const double dt = period() / steps;
  for (int i = 0; i < steps; ++i) {
    drive(dt);
    people_->step(dt, {X_ML_.position(), {0.0, 0.0}, 0.3});
  }
  sweep_.time = sweep_.time + Duration::seconds(period());
  sweep_.X_ML = X_ML_;
  sweep_.X_OL = X_OL_;
  sweep_.legs = people_->legs();
  sweep_.people = people_->people();
  sweep_.exact = scanner_->scan(*scene_, sweep_.legs, X_ML_);
  find_legs();
  std::vector<std::uint8_t> on_leg;
  for (const int leg : sweep_.leg_of) on_leg.push_back(leg >= 0);
  sweep_.scan = as_measured(sweep_.exact, on_leg, scanner_model_, random_);
  return sweep_;
}

void TrainingRoom::find_legs() {
  const std::vector<float>& ranges = sweep_.exact.ranges;
  sweep_.leg_of.assign(ranges.size(), -1);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!std::isfinite(ranges[i])) continue;
    const double bearing =
        X_ML_.theta + sweep_.exact.angle_min + static_cast<double>(i) * sweep_.exact.angle_increment;
    for (std::size_t leg = 0; leg < sweep_.legs.size(); ++leg) {
      // In floats a range is good to a micrometre.
      if (ray_hit(X_ML_.position(), direction(bearing), sweep_.legs[leg]) <= double{ranges[i]} + 1e-5)
        sweep_.leg_of[i] = static_cast<int>(leg);
    }
  }
}

LaserSweep TrainingRoom::view() const {
  return {sweep_.time,
          sweep_.X_OL,
          sweep_.scan.angle_min,
          sweep_.scan.angle_increment,
          scanner_model_.laser.range_min,
          scanner_model_.laser.range_max,
          sweep_.scan.ranges};
}

}  // namespace bw::people
