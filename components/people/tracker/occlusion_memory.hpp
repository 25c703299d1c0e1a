// Where somebody may be who is not seen: guesses that walk on from where they were seen last (a particle
// filter). They go on as people do, neither through what was seen to stand nor, for long, where the laser
// sees that nobody is; they gather in what is hidden, and spread at walls and doors. All in S, the tracker's
// frame.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "components/model/random.hpp"
#include "components/people/detection.hpp"
#include "components/people/tracker/seen_walls.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

class OcclusionMemory {
 public:
  /// Last seen at `position`, going at `velocity`.
  OcclusionMemory(const Vector2& position, const Vector2& velocity, Random& random,
                  const HiddenOptions& options);

  /// They walk so often [s], with every second sweep of ten a second: less often, and then farther.
  static constexpr double kEvery = 0.19;

  /// `dt` >= 0 [s] later. The sweep looked for `looked` [s], since the one before of its sensor. Whether they
  /// have walked; else they do so with one of the next sweeps.
  bool pass(double dt, double looked, const DetectionSet& sweep, const SeenWalls& walls, Random& random,
            const HiddenOptions& options);

  /// How probably they are still somewhere about: it falls where positions are seen empty. 0 to 1.
  double existence() const { return existence_; }

  /// How probably they are within 0.75 m of `position`.
  double chance_near(const Vector2& position) const;

  /// Mean of the guesses as (x, y, vx, vy), and their covariance.
  struct Moments {
    Eigen::Vector4d mean;
    Eigen::Matrix4d covariance;
  };
  Moments moments() const;

  /// How probably they were at `position` `ago` [s], going at `velocity` if that is known, as a density
  /// [1 / (m^2 (m/s)^2)].
  double density(const Vector2& position, std::optional<Vector2> velocity, double ago,
                 const HiddenOptions& options) const;

 private:
  struct Guess {
    Vector2 position;
    Vector2 velocity;
    double weight;
  };
  void walk(const DetectionSet& sweep, const SeenWalls& walls, Random& random, const HiddenOptions& options);
  void draw_anew(Random& random);

  std::vector<Guess> guesses_;
  double existence_ = 1.0;
  double waited_ = 0.0;  ///< since they have walked [s]
  double looked_ = 0.0;  ///< of it the laser looked for so long [s]
};

}  // namespace bw::people
