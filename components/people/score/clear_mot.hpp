// How well tracks agree with the truth: CLEAR MOT (Bernardin and Stiefelhagen, EURASIP 2008), and times to
// confirm, velocities and identities beside it. Only confirmed people count (bw::kConfirmed), as hits and as
// false.
//
//   MOTA = 1 - (misses + false positives + identity switches) / people,   MOTP: mean distance of the matched
//
// Matches of the last sweep stay while they are within the radius; the rest is assigned at least cost.
//
//   IDF1 = 2 IDTP / (people + tracks)    (Ristani et al., ECCV workshops 2016)
//
// IDTP: sweeps in which somebody is within the radius of the one track that stands for them from beginning to
// end, each track for one person at most, chosen so that they are most. GOSPA: gospa.hpp, its mean over
// sweeps. Tracks on who is not counted, or out of the area that counts, are left out of both.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "components/model/tracked_person.hpp"
#include "components/people/score/gospa.hpp"
#include "components/people/tracker/assignment.hpp"
#include "runtime/base/quantile.hpp"

namespace bw::people {

/// One person in one sweep, in O.
struct TruePerson {
  std::uint32_t id = 0;
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  bool counted = true;     ///< belongs to those who should be tracked; tracks on others are not false
  bool unoccluded = true;  ///< plainly visible in this sweep
};

struct Score {
  // CLEAR MOT over all who are counted.
  long people = 0;
  long matched = 0;
  long false_positives = 0;
  long switches = 0;
  long switches_seen = 0;  ///< of them: not because the person was out of sight for more than 2 s
  double distance = 0.0;   ///< sum over the matched [m]
  long identified = 0;     ///< IDTP; known when the keeper is closed
  double gospa = 0.0;      ///< sum over sweeps [m]
  long sweeps = 0;
  // Over those counted and unoccluded.
  long plain = 0;
  long plain_matched = 0;
  // Velocity of matches whose track has held the person for 1 s: all, and those of people who did not turn.
  long velocities = 0;
  double velocity_square = 0.0;
  long steady = 0;
  double steady_square = 0.0;
  // Time in plain view before first matched; who never was counts with theirs if that is half a second [s].
  std::vector<double> confirmation;          ///< of everybody
  std::vector<double> walkers_confirmation;  ///< of those who walked before, and only while they walked
  double person_seconds = 0.0;

  double mota() const {
    return 1.0 -
           static_cast<double>(people - matched + false_positives + switches) / static_cast<double>(people);
  }
  double motp() const { return distance / static_cast<double>(matched); }
  double idf1() const {
    return 2.0 * static_cast<double>(identified) / static_cast<double>(people + matched + false_positives);
  }
  double mean_gospa() const { return gospa / static_cast<double>(sweeps); }
  double recall() const { return static_cast<double>(plain_matched) / static_cast<double>(plain); }
  double precision() const {
    return static_cast<double>(matched) / static_cast<double>(matched + false_positives);
  }
  double velocity_rmse() const { return std::sqrt(velocity_square / static_cast<double>(velocities)); }
  double steady_rmse() const { return std::sqrt(steady_square / static_cast<double>(steady)); }
  double person_minutes() const { return person_seconds / 60.0; }
  double switches_per_ten_minutes() const { return 10.0 * static_cast<double>(switches) / person_minutes(); }
  double seen_switches_per_ten_minutes() const {
    return 10.0 * static_cast<double>(switches_seen) / person_minutes();
  }
  /// Share `q` of those who walked were confirmed within so many seconds, to the millisecond.
  double walkers_confirmation_quantile(double q) const {
    return std::round(1e3 * quantile(walkers_confirmation, q)) / 1e3;
  }
  void add(const Score& other);
};

class ScoreKeeper {
 public:
  static constexpr double kRadius = 0.75;   ///< Leigh et al. 2015
  static constexpr double kWalking = 0.3;   ///< who is faster walks [m/s]
  static constexpr double kPatience = 0.5;  ///< who was never confirmed counts after this time [s]

  /// The next sweep, at `now` [s]. `counts_if_false`: whether a track that matches nobody is held against the
  /// tracker, by its position.
  void add(double now, const std::vector<TruePerson>& truth, const std::vector<TrackedPerson>& tracks,
           const std::function<bool(const Vector2&)>& counts_if_false);

  /// Nothing more comes: those who wait for their confirmation are counted, and identities.
  void close();

  const Score& score() const { return score_; }

  /// The track that follows this person in the last sweep; 0: none.
  std::uint32_t track_of(std::uint32_t person) const;

  /// Tracks that were false in the last sweep.
  const std::vector<std::uint32_t>& false_tracks() const { return false_tracks_; }

  /// Called for everybody whose velocity is judged: held for 1 s, and whether they kept theirs for 0.5 s.
  std::function<void(const TruePerson&, const TrackedPerson&, bool steady)> on_followed;

 private:
  struct Memory {
    std::uint32_t track = 0;   ///< matched last; 0: never
    double matched_since = 0;  ///< by this track, without a gap
    bool was_matched = false;  ///< in the last sweep
    double in_sight = -1e9;    ///< last time plainly visible
    double hidden = 0.0;       ///< longest time out of sight since last matched [s]
    std::optional<double> first_sight;
    bool confirmed = false;
    double waited = 0.0;          ///< in plain view, not yet matched [s]
    double waited_walking = 0.0;  ///< of it, while walking [s]
    bool walked = false;          ///< in plain view, before they were matched
    Vector2 velocity{0.0, 0.0};
    double velocity_changed = -1e9;  ///< last time the velocity changed at more than 0.5 m/s^2
  };

  void match(const std::vector<TruePerson>& truth);
  void compare(const std::vector<TruePerson>& truth);
  void identify();
  void keep_matches(const std::vector<TruePerson>& truth);
  void judge(double now, const TruePerson& person, int matched);
  void look(double now, const TruePerson& person, Memory& memory);
  void wait(double now, const TruePerson& person, Memory& memory) const;
  void follow(double now, const TruePerson& person, const TrackedPerson& track, Memory& memory);
  void judge_velocity(double now, const TruePerson& person, const TrackedPerson& track, const Memory& memory);

  Score score_;
  std::optional<double> last_;  ///< time of the last sweep [s]
  std::vector<TrackedPerson> confirmed_;
  std::map<std::uint32_t, Memory> memory_;
  Assignment assignment_;
  std::vector<int> match_;
  std::vector<char> taken_;
  std::vector<std::uint32_t> false_tracks_;
  Gospa gospa_;
  /// Sweeps in which a person (first) was within the radius of a track (second).
  std::map<std::pair<std::uint32_t, std::uint32_t>, long> together_;
};

}  // namespace bw::people
