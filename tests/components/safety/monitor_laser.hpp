// The laser of a scene: rays to things, lost beams, a mast, a cover; a head that rotates takes its beams one
// after the other.
#pragma once

#include <vector>

#include "components/model/laser_sweep.hpp"
#include "components/model/random.hpp"
#include "tests/components/safety/monitor_scene.hpp"

namespace bw::safety::test {

class Laser {
 public:
  explicit Laser(const Scene& scene);

  struct Sweep {
    double begun = 0.0, ended = 0.0;  ///< [s]
    std::vector<Pose2> X_WL;          ///< of each beam
    std::vector<float> ranges;
    double middle() const { return 0.5 * (begun + ended); }
  };

  Sweep begin(double t) const;
  /// The beams that are due by `t`; true when it is whole.
  bool go_on(Sweep& sweep, double t, const Pose2& X_WB, const std::vector<Capsule>& things);
  /// What its driver says of it, by its own clock.
  LaserSweep view(const Sweep& sweep) const;

  /// Whether `position` (world) is in the field, the first thing in the way, and no lost beam: four of five
  /// beams.
  bool shows(const Sweep& sweep, const Vector2& position) const;
  /// Whether no beam near the line to `position` says anything: it lies outside of the field, or behind the
  /// mast.
  bool is_blind_to(const Sweep& sweep, const Vector2& position) const;

 private:
  bool is_round() const { return numbers_[kField] > 6.28; }
  double increment() const { return numbers_[kField] / (numbers_[kBeams] - (is_round() ? 0.0 : 1.0)); }
  double angle_of(double beam) const { return -0.5 * numbers_[kField] + beam * increment(); }
  /// Which beam would look at `position`, between 0 and a full revolution of beams.
  double beam_to(const Sweep& sweep, const Vector2& position) const;
  /// Distance to `thing` of each beam that meets it sooner than what is there in `nearest`, of the beams from
  /// `first` on.
  void meet(const Capsule& thing, const Pose2& X_WL, std::size_t first, std::vector<double>& nearest) const;
  /// What a beam says whose light goes so far.
  float reading(double angle, double t, double distance);

  const std::array<double, kNumbers>& numbers_;
  Random random_;
  Pose2 X_BL_;
};

}  // namespace bw::safety::test
