// The world's people by social forces (components/world/social_walkers.hpp) as movers of a scene; they see the robot. Metres,
// seconds.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "components/lab/bench/scene_drive.hpp"
#include "components/world/social_walkers.hpp"

namespace bw {

inline constexpr double kComesIn = 3.0;  ///< [m]

/// Whoever leaves it along x at one end comes in at the other, as somebody else, so that as many are there at any time; but
/// not within kComesIn of the robot: they walk on until there is room.
struct SceneLoop {
  double from = 0.0;
  double to = 0.0;  ///< not above `from`: none
};

class SocialPeople final : public SceneMovers {
 public:
  /// Of somebody now: true while they stand and wait.
  using Waits = std::function<bool(const SceneDisc& person, const SceneRobot& robot)>;

  /// Speeds are drawn from `seed`.
  SocialPeople(const SocialWalkersOptions& options, const StaticObstacles& walls, std::uint64_t seed,
               SceneLoop loop, Waits waits = {});
  std::unique_ptr<SceneMovers> clone() const override { return std::make_unique<SocialPeople>(*this); }
  const std::vector<SceneDisc>& discs() const override { return discs_; }
  void step(const SceneRobot& robot) override;

 private:
  void go_round(const Vector2& robot);

  std::shared_ptr<const StaticScene> walls_;  ///< `model_` looks at them
  SocialWalkers model_;
  SceneLoop loop_;
  Waits waits_;
  std::vector<Person> people_;
  std::vector<SceneDisc> discs_;
};

}  // namespace bw
