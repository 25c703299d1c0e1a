#include "components/lab/bench/flows/social_people.hpp"

#include <algorithm>
#include <utility>

namespace bw {

SocialPeople::SocialPeople(const SocialWalkersOptions& options, const StaticObstacles& walls,
                           std::uint64_t seed, SceneLoop loop, Waits waits)
    : walls_(std::make_shared<const StaticScene>(walls, std::nullopt)),
      model_(options, *walls_, 0, Random(seed)),
      loop_(loop),
      waits_(std::move(waits)) {
  model_.step(0.0, {{}, {}}, people_);
  for (const Person& p : people_) discs_.push_back({p.id, p.position, p.velocity, p.radius});
}

void SocialPeople::step(const SceneRobot& robot) {
  if (waits_ && std::ranges::any_of(discs_, [&](const SceneDisc& d) { return waits_(d, robot); })) {
    for (SceneDisc& disc : discs_) disc.velocity.setZero();
    return;
  }
  const RobotBody body{robot.position, robot.velocity, 0.3};
  const std::vector<Person> nobody_else;
  people_.clear();
  model_.step(kSceneStep, {nobody_else, {&body, 1}}, people_);
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    discs_[i].position = people_[i].position;
    discs_[i].velocity = people_[i].velocity;
  }
  if (loop_.to > loop_.from) go_round(robot.position);
}

void SocialPeople::go_round(const Vector2& robot) {
  const auto count = static_cast<std::uint32_t>(discs_.size());
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const double x = discs_[i].position.x();
    if (x >= loop_.from && x <= loop_.to) continue;
    const Vector2 by((x > loop_.to ? -1.0 : 1.0) * (loop_.to - loop_.from), 0.0);
    if ((discs_[i].position + by - robot).norm() < kComesIn) continue;
    model_.displace(people_[i].id, by);
    discs_[i].position += by;
    discs_[i].id += count;
  }
}

}  // namespace bw
