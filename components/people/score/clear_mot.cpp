#include "components/people/score/clear_mot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "components/model/mover_weight.hpp"

namespace bw::people {

void Score::add(const Score& other) {
  people += other.people;
  matched += other.matched;
  false_positives += other.false_positives;
  switches += other.switches;
  switches_seen += other.switches_seen;
  distance += other.distance;
  identified += other.identified;
  gospa += other.gospa;
  sweeps += other.sweeps;
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

void ScoreKeeper::add(double now, const std::vector<TruePerson>& truth,
                      const std::vector<TrackedPerson>& tracks,
                      const std::function<bool(const Vector2&)>& counts_if_false) {
  confirmed_.clear();
  std::ranges::copy_if(tracks, std::back_inserter(confirmed_),
                       [](const TrackedPerson& track) { return is_confirmed(track); });
  match(truth);
  for (std::size_t i = 0; i < truth.size(); ++i) judge(now, truth[i], match_[i]);
  false_tracks_.clear();
  for (std::size_t j = 0; j < confirmed_.size(); ++j) {
    if (taken_[j] == 0 && counts_if_false(confirmed_[j].position)) false_tracks_.push_back(confirmed_[j].id);
  }
  score_.false_positives += static_cast<long>(false_tracks_.size());
  compare(truth);
  last_ = now;
}

void ScoreKeeper::close() {
  for (auto& [id, memory] : memory_) {
    if (memory.confirmed) continue;
    if (memory.waited >= kPatience) score_.confirmation.push_back(memory.waited);
    if (memory.waited_walking >= kPatience) score_.walkers_confirmation.push_back(memory.waited_walking);
    memory.confirmed = true;
  }
  identify();
}

/// Who counts with the tracks that do: those matched with them, and the false ones.
void ScoreKeeper::compare(const std::vector<TruePerson>& truth) {
  std::vector<Vector2> people, positions;
  std::vector<std::size_t> tracks;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!truth[i].counted) continue;
    people.push_back(truth[i].position);
    if (match_[i] >= 0) tracks.push_back(static_cast<std::size_t>(match_[i]));
  }
  for (std::size_t j = 0; j < confirmed_.size(); ++j)
    if (std::ranges::count(false_tracks_, confirmed_[j].id) > 0) tracks.push_back(j);
  for (const std::size_t j : tracks) {
    positions.push_back(confirmed_[j].position);
    for (const TruePerson& person : truth) {
      if (person.counted && (person.position - confirmed_[j].position).norm() <= kRadius)
        ++together_[{person.id, confirmed_[j].id}];
    }
  }
  score_.gospa += gospa_(people, positions);
  ++score_.sweeps;
}

/// One track for each person, from beginning to end, so that the sweeps in which they are together are most.
void ScoreKeeper::identify() {
  std::map<std::uint32_t, std::size_t> column;
  for (const auto& [pair, count] : together_) column.try_emplace(pair.second, column.size());
  assignment_.begin(column.size());
  std::optional<std::uint32_t> row;
  for (const auto& [pair, count] : together_) {
    if (row != pair.first) assignment_.add_row(0.0);
    row = pair.first;
    assignment_.allow(column.at(pair.second), -static_cast<double>(count));
  }
  assignment_.solve();
  score_.identified = std::lround(-assignment_.total());
}

std::uint32_t ScoreKeeper::track_of(std::uint32_t person) const {
  const auto known = memory_.find(person);
  return known != memory_.end() && known->second.was_matched ? known->second.track : 0;
}

void ScoreKeeper::keep_matches(const std::vector<TruePerson>& truth) {
  match_.assign(truth.size(), -1);
  taken_.assign(confirmed_.size(), 0);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto known = memory_.find(truth[i].id);
    if (known == memory_.end() || !known->second.was_matched) continue;
    for (std::size_t j = 0; j < confirmed_.size(); ++j) {
      if (confirmed_[j].id != known->second.track || taken_[j] != 0) continue;
      if ((confirmed_[j].position - truth[i].position).norm() > kRadius) continue;
      match_[i] = static_cast<int>(j);
      taken_[j] = 1;
    }
  }
}

void ScoreKeeper::match(const std::vector<TruePerson>& truth) {
  keep_matches(truth);
  assignment_.begin(confirmed_.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    assignment_.add_row(1.0);
    if (match_[i] >= 0) continue;
    for (std::size_t j = 0; j < confirmed_.size(); ++j) {
      const double distance = (confirmed_[j].position - truth[i].position).norm();
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

void ScoreKeeper::wait(double now, const TruePerson& person, Memory& memory) const {
  const bool walks = person.velocity.norm() > kWalking;
  memory.walked = memory.walked || walks;
  if (!last_ || memory.in_sight != *last_) return;  // new in view
  memory.waited += now - *last_;
  if (walks) memory.waited_walking += now - *last_;
}

void ScoreKeeper::look(double now, const TruePerson& person, Memory& memory) {
  if (!memory.first_sight) memory.velocity = person.velocity;
  if ((person.velocity - memory.velocity).norm() > 0.05) memory.velocity_changed = now;
  memory.velocity = person.velocity;
  const bool plain = person.counted && person.unoccluded;
  if (plain) {
    if (!memory.first_sight) memory.first_sight = now;
    if (!memory.confirmed) wait(now, person, memory);
    if (now > *memory.first_sight) memory.hidden = std::max(memory.hidden, now - memory.in_sight);
    memory.in_sight = now;
    ++score_.plain;
  }
  if (person.counted) {
    ++score_.people;
    score_.person_seconds += last_ ? now - *last_ : 0.0;
  }
}

void ScoreKeeper::judge(double now, const TruePerson& person, int matched) {
  Memory& memory = memory_[person.id];
  look(now, person, memory);
  if (!person
           .counted) {  // who is not to be followed changes identity unnoticed: it counts when they are back
    const bool kept = matched >= 0 && confirmed_[static_cast<std::size_t>(matched)].id == memory.track;
    memory.was_matched = memory.was_matched && kept;
  } else if (matched < 0) {
    memory.was_matched = false;
  } else {
    follow(now, person, confirmed_[static_cast<std::size_t>(matched)], memory);
  }
}

void ScoreKeeper::follow(double now, const TruePerson& person, const TrackedPerson& track, Memory& memory) {
  const bool other = memory.track != track.id;
  if (memory.track != 0 && other) {
    ++score_.switches;
    if (memory.hidden < 2.0) ++score_.switches_seen;
  }
  if (other || !memory.was_matched) memory.matched_since = now;
  memory.track = track.id;
  memory.was_matched = true;
  memory.hidden = 0.0;
  if (!memory.confirmed && memory.first_sight) {
    memory.confirmed = true;
    score_.confirmation.push_back(memory.waited);
    if (memory.walked) score_.walkers_confirmation.push_back(memory.waited_walking);
  }
  ++score_.matched;
  score_.distance += (track.position - person.position).norm();
  if (person.unoccluded) ++score_.plain_matched;
  if (now - memory.matched_since >= 1.0 - 1e-9) judge_velocity(now, person, track, memory);
}

void ScoreKeeper::judge_velocity(double now, const TruePerson& person, const TrackedPerson& track,
                                 const Memory& memory) {
  const double error = (track.velocity - person.velocity).squaredNorm();
  ++score_.velocities;
  score_.velocity_square += error;
  const bool steady = now - memory.velocity_changed > 0.5;
  if (on_followed) on_followed(person, track, steady);
  if (!steady) return;
  ++score_.steady;
  score_.steady_square += error;
}

}  // namespace bw::people
