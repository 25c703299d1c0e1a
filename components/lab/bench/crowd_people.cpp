#include "components/lab/bench/crowd_people.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "components/lab/bench/crowd_walk.hpp"
#include "components/model/random.hpp"
#include "components/world/orca_walkers.hpp"
#include "components/world/social_walkers.hpp"
#include "runtime/base/named_seed.hpp"

namespace bw {
namespace {

constexpr double kLeastDistance = 4.0;  // [m] from start to goal
constexpr double kFreeAtGoal = 0.1;     // [m] edge to edge of static discs
constexpr double kLeastSpeed = 0.3;     // [m/s]
constexpr double kMaxSpeed = 1.2;       // [m/s]
constexpr double kRounding = 1e-9;      // [s]

StaticScene statics_of(const Scene& scene) {
  StaticObstacles shapes;
  for (const SceneObstacle& o : scene.obstacles)
    if (!o.moves()) shapes.discs.push_back({o.position, o.radius});
  return {shapes, std::nullopt};
}

bool is_free(const Scene& scene, const Vector2& position, double radius) {
  return std::all_of(scene.obstacles.begin(), scene.obstacles.end(), [&](const SceneObstacle& o) {
    return o.moves() || (o.position - position).norm() >= o.radius + radius + kFreeAtGoal;
  });
}

Vector2 draw_goal(const Scene& scene, const SceneBox& box, const SceneObstacle& walker, Random& random) {
  constexpr int kMaxTries = 10'000;
  Vector2 goal = walker.position;
  for (int attempt = 0; attempt < kMaxTries; ++attempt) {
    const double x = random.uniform(box.x_min + walker.radius, box.x_max - walker.radius);
    const double y = random.uniform(box.y_min + walker.radius, box.y_max - walker.radius);
    goal = {x, y};
    if ((goal - walker.position).norm() >= kLeastDistance && is_free(scene, goal, walker.radius)) break;
  }
  return goal;
}

template <class Options>
Options options_of(const Scene& scene, const SceneBox& box, Random& random) {
  Options options;
  options.speed_min = kLeastSpeed;
  options.speed_max = kMaxSpeed;
  for (const SceneObstacle& o : scene.obstacles) {
    if (!o.moves()) continue;
    const Vector2 goal = draw_goal(scene, box, o, random);
    options.walkers.push_back({o.position.x(), o.position.y(), goal.x(), goal.y()});
    options.radius = o.radius;
  }
  return options;
}

}  // namespace

CrowdPeople::CrowdPeople(const Scene& scene, const ClosedLoop& rule)
    : scene_(scene), rule_(rule), statics_(statics_of(scene)) {
  if (rule_.walkers == WalkersManner::straight) return;
  for (const SceneObstacle& o : scene_.obstacles) {
    person_of_.push_back(people_.size());
    if (o.moves()) people_.emplace_back();
  }
  Random random(named_seed(scene_.name, 0));
  if (rule_.walkers == WalkersManner::orca) {
    const auto options = options_of<OrcaWalkersOptions>(scene_, rule_.box, random);
    model_ = std::make_unique<OrcaWalkers>(options, statics_, 1, random);
  } else {
    const auto options = options_of<SocialWalkersOptions>(scene_, rule_.box, random);
    model_ = std::make_unique<SocialWalkers>(options, statics_, 1, random);
  }
  people_.clear();
  model_->step(0.0, {nobody_else_, {}}, people_);
}

void CrowdPeople::move_to(double time, const Pose2& robot, const Twist2& twist) {
  const double dt = time - time_;
  time_ = time;
  if (!model_ || dt <= kRounding) return;
  const RobotBody body{robot.position(),
                       {twist.v * std::cos(robot.theta), twist.v * std::sin(robot.theta)},
                       rule_.robot_radius};
  people_.clear();
  model_->step(dt, {nobody_else_, {&body, 1}}, people_);
}

Vector2 CrowdPeople::position(std::size_t i) const {
  if (model_ && walks(i)) return people_[person_of_[i]].position;
  return position_at(scene_.obstacles[i], rule_.box, time_);
}

Vector2 CrowdPeople::velocity(std::size_t i) const {
  if (model_ && walks(i)) return people_[person_of_[i]].velocity;
  return velocity_at(scene_.obstacles[i], rule_.box, time_);
}

}  // namespace bw
