// People by the social forces of libpedsim as T-MPC's experiments have them (bench/protocols.md 8.15): drawn to a goal, round
// each other and the robot, off the nearest wall. Metres, seconds.
#pragma once

#include <vector>

#include "components/lab/bench/scene_drive.hpp"
#include "components/model/obstacles.hpp"

namespace bw {

struct PedsimPerson {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  Vector2 goal{0.0, 0.0};
  Vector2 other_goal{0.0, 0.0};  ///< where they turn to within kPedsimArrived of the goal
  double speed = 1.2;            ///< at most [m/s]
};

inline constexpr double kPedsimArrived = 3.0;  ///< [m]

/// Acceleration [m/s^2] of person `i`.
Vector2 pedsim_force(const std::vector<PedsimPerson>& people, std::size_t i, const SceneRobot& robot,
                     const std::vector<Segment>& walls);

/// All of them kSceneStep on, each by what was before.
void pedsim_step(std::vector<PedsimPerson>& people, const SceneRobot& robot,
                 const std::vector<Segment>& walls);

/// As movers of a scene.
class PedsimPeople final : public SceneMovers {
 public:
  PedsimPeople(std::vector<PedsimPerson> people, std::vector<Segment> walls, double radius);
  std::unique_ptr<SceneMovers> clone() const override { return std::make_unique<PedsimPeople>(*this); }
  const std::vector<SceneDisc>& discs() const override { return discs_; }
  void step(const SceneRobot& robot) override;

 private:
  void place();

  std::vector<PedsimPerson> people_;
  std::vector<Segment> walls_;
  std::vector<SceneDisc> discs_;
};

}  // namespace bw
