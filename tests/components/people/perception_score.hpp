// How well tracks agree with the truth: CLEAR MOT (Bernardin and Stiefelhagen, EURASIP 2008), and times to
// confirm, velocities and identities beside it. Only confirmed people count (bw::kConfirmed), as hits and as
// false.
//
//   MOTA = 1 - (misses + false positives + identity switches) / people,   MOTP: mean distance of the matched
//
// Matches of the last sweep stay while they are within the radius; the rest is assigned at least cost.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <vector>

#include "components/people/tracker/assignment.hpp"
#include "components/people/tracker/tracker.hpp"
#include "runtime/base/quantile.hpp"

namespace bw::people::test {

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
  /// Share `q` of those who walked were confirmed within so many seconds, to the millisecond.
  double walkers_confirmation_quantile(double q) const {
    return std::round(1e3 * quantile(walkers_confirmation, q)) / 1e3;
  }
  double motp() const { return distance / static_cast<double>(matched); }
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
  void add(const Score& other) {
    people += other.people;
    matched += other.matched;
    false_positives += other.false_positives;
    switches += other.switches;
    switches_seen += other.switches_seen;
    distance += other.distance;
    plain += other.plain;
    plain_matched += other.plain_matched;
    velocities += other.velocities;
    velocity_square += other.velocity_square;
    steady += other.steady;
    steady_square += other.steady_square;
    confirmation.insert(confirmation.end(), other.confirmation.begin(), other.confirmation.end());
    walkers_confirmation.insert(walkers_confirmation.end(), other.walkers_confirmation.begin(),
                                other.walkers_confirmation.end());
    person_seconds += other.person_seconds;
  }
};

class ScoreKeeper {
 public:
  static constexpr double kRadius = 0.75;   ///< Leigh et al. 2015
  static constexpr double kWalking = 0.3;   ///< who is faster walks [m/s]
  static constexpr double kPatience = 0.5;  ///< who was never confirmed counts after this time [s]

  /// `counts_if_false`: whether a track that matches nobody is held against the tracker, by its place.
  template <class CountsIfFalse>
  void add(double now, const std::vector<TruePerson>& truth, const std::vector<TrackedPerson>& tracks,
           const CountsIfFalse& counts_if_false) {
    confirmed_.clear();
    std::ranges::copy_if(tracks, std::back_inserter(confirmed_),
                         [](const TrackedPerson& track) { return track.confidence >= kConfirmed; });
    match(truth, confirmed_);
    for (std::size_t i = 0; i < truth.size(); ++i) judge(now, truth[i], match_[i]);
    for (std::size_t j = 0; j < confirmed_.size(); ++j)
      if (taken_[j] == 0 && counts_if_false(confirmed_[j].position)) ++score_.false_positives;
    last_ = now;
  }

  /// Nothing more comes: those who wait for their confirmation are counted.
  void close() {
    for (auto& [id, memory] : memory_) {
      if (memory.confirmed) continue;
      if (memory.waited >= kPatience) score_.confirmation.push_back(memory.waited);
      if (memory.waited_walking >= kPatience) score_.walkers_confirmation.push_back(memory.waited_walking);
      memory.confirmed = true;
    }
  }

  const Score& score() const { return score_; }

  /// The track that follows this person in the last sweep; 0: none.
  std::uint32_t track_of(std::uint32_t person) const {
    const auto known = memory_.find(person);
    return known != memory_.end() && known->second.was_matched ? known->second.track : 0;
  }

  /// Called for everybody whose velocity is judged: held for 1 s, and whether they kept theirs for 0.5 s.
  std::function<void(const TruePerson&, const TrackedPerson&, bool steady)> on_followed;

 private:
  struct Memory {
    std::uint32_t track = 0;   ///< matched last; 0: never
    double matched_since = 0;  ///< by this track, without a gap
    bool was_matched = false;  ///< in the last sweep
    double in_sight = -1e9;    ///< last time plainly visible
    double hidden = 0.0;       ///< longest time out of sight since last matched [s]
    double first_sight = -1.0;
    bool confirmed = false;
    double waited = 0.0;          ///< in plain view, not yet matched [s]
    double waited_walking = 0.0;  ///< of it, while walking [s]
    bool walked = false;          ///< in plain view, before they were matched
    Vector2 velocity{0.0, 0.0};
    double turned = -1e9;  ///< last time the velocity changed at more than 0.5 m/s^2
  };

  void match(const std::vector<TruePerson>& truth, const std::vector<TrackedPerson>& tracks) {
    match_.assign(truth.size(), -1);
    taken_.assign(tracks.size(), 0);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const auto known = memory_.find(truth[i].id);
      if (known == memory_.end() || !known->second.was_matched) continue;
      for (std::size_t j = 0; j < tracks.size(); ++j) {
        if (tracks[j].id != known->second.track || taken_[j] != 0) continue;
        if ((tracks[j].position - truth[i].position).norm() > kRadius) continue;
        match_[i] = static_cast<int>(j);
        taken_[j] = 1;
      }
    }
    assignment_.begin(tracks.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
      assignment_.add_row(1.0);
      if (match_[i] >= 0) continue;
      for (std::size_t j = 0; j < tracks.size(); ++j) {
        const double distance = (tracks[j].position - truth[i].position).norm();
        if (taken_[j] == 0 && distance <= kRadius) assignment_.allow(j, distance);
      }
    }
    const std::vector<int>& chosen = assignment_.solve();
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (chosen[i] < 0) continue;
      match_[i] = chosen[i];
      taken_[static_cast<std::size_t>(chosen[i])] = 1;
    }
  }

  void wait(double now, const TruePerson& person, Memory& memory) const {
    const bool walks = person.velocity.norm() > kWalking;
    memory.walked = memory.walked || walks;
    if (memory.in_sight != last_) return;  // new in view
    memory.waited += now - last_;
    if (walks) memory.waited_walking += now - last_;
  }

  void judge(double now, const TruePerson& person, int matched) {
    Memory& memory = memory_[person.id];
    if (memory.first_sight < 0.0) memory.velocity = person.velocity;
    if ((person.velocity - memory.velocity).norm() > 0.05) memory.turned = now;
    memory.velocity = person.velocity;
    const bool plain = person.counted && person.unoccluded;
    if (plain && memory.first_sight < 0.0) memory.first_sight = now;
    if (plain && !memory.confirmed) wait(now, person, memory);
    if (plain && now - memory.first_sight > 0.0)
      memory.hidden = std::max(memory.hidden, now - memory.in_sight);
    if (plain) memory.in_sight = now;
    if (person.counted) {
      ++score_.people;
      score_.person_seconds += now - last_;
    }
    if (plain) ++score_.plain;
    if (!person.counted) {  // who is not to be followed changes identity unnoticed: it counts when they are
                            // back
      const bool kept = matched >= 0 && confirmed_[static_cast<std::size_t>(matched)].id == memory.track;
      memory.was_matched = memory.was_matched && kept;
      return;
    }
    if (matched < 0) {
      memory.was_matched = false;
    } else {
      const TrackedPerson& track = confirmed_[static_cast<std::size_t>(matched)];
      const bool other = memory.track != track.id;
      if (memory.track != 0 && other) {
        ++score_.switches;
        if (memory.hidden < 2.0) ++score_.switches_seen;
      }
      if (other || !memory.was_matched) memory.matched_since = now;
      memory.track = track.id;
      memory.was_matched = true;
      memory.hidden = 0.0;
      if (!memory.confirmed && memory.first_sight >= 0.0) {
        memory.confirmed = true;
        score_.confirmation.push_back(memory.waited);
        if (memory.walked) score_.walkers_confirmation.push_back(memory.waited_walking);
      }
      ++score_.matched;
      score_.distance += (track.position - person.position).norm();
      if (plain) ++score_.plain_matched;
      if (now - memory.matched_since >= 1.0 - 1e-9) {
        const double error = (track.velocity - person.velocity).squaredNorm();
        ++score_.velocities;
        score_.velocity_square += error;
        const bool steady = now - memory.turned > 0.5;
        if (on_followed) on_followed(person, track, steady);
        if (steady) {
          ++score_.steady;
          score_.steady_square += error;
        }
      }
    }
  }

  Score score_;
  double last_ = 0.0;  ///< time of the last sweep [s]
  std::vector<TrackedPerson> confirmed_;
  std::map<std::uint32_t, Memory> memory_;
  Assignment assignment_;
  std::vector<int> match_;
  std::vector<char> taken_;
};

}  // namespace bw::people::test
