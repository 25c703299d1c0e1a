// Something that was seen and is not known to be a person: a leg of somebody new, or furniture. Constant
// velocity, both axes alike, and what was seen of it lately.
#pragma once

#include <algorithm>
#include <cstdint>

#include "components/people/detection.hpp"
#include "components/people/tracker/evidence/existence.hpp"
#include "components/people/tracker/evidence/foot_shifts.hpp"
#include "components/people/tracker/evidence/past_sweeps.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::people {

/// One sweep's view of a cluster.
struct Sighting {
  int source = 0;          ///< of several sensors
  std::int64_t sweep = 0;  ///< counts sweeps
  double time = 0.0;       ///< [s], from the tracker's own origin
  Vector2 position{0.0, 0.0};
  double variance = 0.01;  ///< per axis [m^2]
  double leg_score = 0.0;
  double body_score = 0.0;
  bool on_static = false;
  bool occluded = false;
  double width = 0.0;    ///< [m]
  double bearing = 0.0;  ///< along which the laser saw it [rad]
  std::int64_t nth = 0;  ///< counts all sightings of the same thing

  double human_score() const { return std::max(leg_score, body_score); }
  /// At even odds: its log odds are what it says for a part of a person, of either kind.
  double likeness() const { return std::min(1.0, leg_score + body_score); }
};

class ClusterTrack {
 public:
  static constexpr int kRemembered = 12;
  /// [s] of sightings that follow each other faster the last is remembered, so that what is remembered spans
  /// a second at any rate
  static constexpr double kSpacing = 0.075;

  explicit ClusterTrack(const Sighting& first);

  void predict(double dt);
  void correct(const Sighting& seen);

  const Vector2& position() const { return position_; }
  const Vector2& velocity() const { return velocity_; }
  double variance() const { return p_; }  ///< of the position, per axis [m^2]

  /// How many sightings are remembered, and the k-th latest of them (0: the last).
  int remembered() const { return count_ < kRemembered ? static_cast<int>(count_) : kRemembered; }
  int source() const { return source_; }  ///< that saw it first
  double born() const { return born_; }   ///< first sighting [s]
  const Sighting& sighting(int k) const { return ring_[(count_ - 1 - k) % kRemembered]; }
  const Sighting& last() const { return sighting(0); }

  FootShifts foot_shifts;
  Existence existence;   ///< as a leg, or somebody whole
  std::uint32_t id = 0;  ///< as a possible person; 0: not told of
  /// What was at its position before, when that was looked up last [s], and where.
  PastSweeps::Past past = PastSweeps::Past::unknown;
  double looked_up = -1e9;
  Vector2 looked_up_at{0.0, 0.0};

 private:
  void remember(const Sighting& seen);

  Vector2 position_;
  Vector2 velocity_{0.0, 0.0};
  double p_;         ///< variance of the position [m^2]
  double pv_ = 0.0;  ///< with the velocity
  double vv_ = 1.0;  ///< of the velocity [m^2/s^2]: legs swing at up to 2.5 m/s
  int source_;
  double born_;
  std::int64_t count_ = 0;  ///< remembered or forgotten
  Sighting ring_[kRemembered];
};

}  // namespace bw::people
