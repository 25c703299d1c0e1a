#include "components/people/score/stretch_score.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

#include <Eigen/LU>

#include "components/model/mover_weight.hpp"

namespace bw::people {
namespace {

constexpr double kInside = 5.991464547;  // chi-square of 95 %, 2 degrees of freedom
constexpr double kSameTime = 1e-6;       // [s]

std::function<bool(const Vector2&)> judged_area(const std::optional<Disc>& judged) {
  return [judged](const Vector2& p) { return !judged || (p - judged->center).norm() <= judged->radius; };
}

bool is_near(const Vector2& a, const Vector2& b) { return (a - b).norm() <= ScoreKeeper::kRadius; }

/// Where the track said that its person would be, linear between what it says.
std::optional<PredictedPosition> predicted(const TrackedPerson& track, double ahead) {
  PredictedPosition before{0.0, track.position, track.covariance.topLeftCorner<2, 2>()};
  for (const PredictedPosition& next : track.predictions) {
    if (next.time >= ahead - kSameTime && next.time > before.time) {
      const double share = std::min((ahead - before.time) / (next.time - before.time), 1.0);
      return PredictedPosition{ahead, before.position + share * (next.position - before.position),
                               before.covariance + share * (next.covariance - before.covariance)};
    }
    before = next;
  }
  return std::nullopt;
}

class StretchJudge {
 public:
  StretchJudge(const std::vector<LabelledInstant>& labels, const std::vector<TrackedSweep>& sweeps,
               const StretchOptions& options)
      : labels_(labels), sweeps_(sweeps), options_(options), paths_(labels, options.longest_step) {}

  StretchScore judge() {
    for (const LabelledInstant& instant : labels_) judge_instant(instant);
    at_labels_.close();
    score_.instants = static_cast<long>(labels_.size());
    score_.clear_mot = at_labels_.score();
    if (!labels_.empty()) judge_sweeps();
    score_.clear_mot.confirmation = at_sweeps_.score().confirmation;
    score_.clear_mot.walkers_confirmation = at_sweeps_.score().walkers_confirmation;
    for (const auto& [step, horizon] : horizons_) score_.horizons.push_back(horizon);
    return std::move(score_);
  }

 private:
  /// Of the nearest sweep, moved on to the label's time; nobody if that is too far.
  std::vector<TrackedPerson> tracks_at(double time) const {
    const auto is_before = [](const TrackedSweep& sweep, double t) { return sweep.time < t; };
    auto nearest = std::lower_bound(sweeps_.begin(), sweeps_.end(), time, is_before);
    if (nearest != sweeps_.begin() &&
        (nearest == sweeps_.end() || time - (nearest - 1)->time <= nearest->time - time))
      --nearest;
    if (nearest == sweeps_.end() || std::abs(nearest->time - time) > options_.sweep_distance) return {};
    std::vector<TrackedPerson> tracks = nearest->people;
    for (TrackedPerson& track : tracks) track.position += (time - nearest->time) * track.velocity;
    return tracks;
  }

  void judge_instant(const LabelledInstant& instant) {
    const std::vector<TrackedPerson> tracks = tracks_at(instant.time);
    const auto is_judged = judged_area(instant.judged);
    at_labels_.add(instant.time, instant.people, tracks, is_judged);
    for (const TruePerson& person : instant.people) {
      if (!person.counted) continue;
      if (const std::uint32_t track = at_labels_.track_of(person.id); track != 0) {
        follow(instant.time, person, track);
      } else {
        miss(instant.time, person, tracks);
      }
    }
    for (const std::uint32_t id : at_labels_.false_tracks()) {
      const Vector2& position = std::ranges::find(tracks, id, &TrackedPerson::id)->position;
      score_.errors.push_back({instant.time, TrackError::false_track, id, position, false});
    }
    for (const TrackedPerson& track : tracks) {
      const bool is_somebody = std::ranges::any_of(
          instant.people, [&](const TruePerson& person) { return is_near(person.position, track.position); });
      if (!is_confirmed(track) && !is_somebody && is_judged(track.position)) ++score_.possible_elsewhere;
    }
  }

  void miss(double time, const TruePerson& person, const std::vector<TrackedPerson>& tracks) {
    const bool is_possible = std::ranges::any_of(tracks, [&](const TrackedPerson& track) {
      return !is_confirmed(track) && is_near(track.position, person.position);
    });
    score_.errors.push_back({time, TrackError::miss, person.id, person.position, is_possible});
    if (is_possible) ++score_.possible_at_misses;
    score_.tracks[person.id];  // they count, also if nobody ever follows them
  }

  void follow(double time, const TruePerson& person, std::uint32_t track) {
    const auto last = last_track_.find(person.id);
    if (last != last_track_.end() && last->second != track)
      score_.errors.push_back({time, TrackError::other_identity, person.id, person.position, false});
    last_track_[person.id] = track;
    score_.tracks[person.id].insert(track);
  }

  void judge_sweeps() {
    const auto is_before = [](const TrackedSweep& sweep, double t) { return sweep.time < t; };
    auto sweep =
        std::lower_bound(sweeps_.begin(), sweeps_.end(), labels_.front().time - kSameTime, is_before);
    for (; sweep != sweeps_.end() && sweep->time <= labels_.back().time + kSameTime; ++sweep) {
      const std::vector<TruePerson> people = paths_.at(sweep->time);
      at_sweeps_.add(sweep->time, people, sweep->people, [](const Vector2&) { return false; });
      for (const TruePerson& person : people) {
        if (const std::uint32_t id = at_sweeps_.track_of(person.id); id != 0 && person.counted)
          judge_predictions(*sweep, person, *std::ranges::find(sweep->people, id, &TrackedPerson::id));
      }
    }
    at_sweeps_.close();
  }

  void judge_predictions(const TrackedSweep& sweep, const TruePerson& person, const TrackedPerson& track) {
    for (int step = 1;; ++step) {
      const double ahead = step * options_.horizon_step;
      const auto there = predicted(track, ahead);
      if (!there) return;
      const auto truth = paths_.at(sweep.time + ahead, person.id);
      if (!truth) continue;
      const Eigen::Matrix2d C = there->covariance + options_.label_deviation * options_.label_deviation *
                                                        Eigen::Matrix2d::Identity();
      const Vector2 error = truth->position - there->position;
      HorizonScore& horizon = horizons_[step];
      horizon.ahead = ahead;
      ++horizon.count;
      horizon.distance += error.norm();
      if (error.dot(C.inverse() * error) < kInside) ++horizon.inside;
    }
  }

  const std::vector<LabelledInstant>& labels_;
  const std::vector<TrackedSweep>& sweeps_;
  const StretchOptions& options_;
  LabelledPaths paths_;
  ScoreKeeper at_labels_;
  ScoreKeeper at_sweeps_;
  std::map<std::uint32_t, std::uint32_t> last_track_;  ///< by person
  std::map<int, HorizonScore> horizons_;               ///< by steps ahead
  StretchScore score_;
};

}  // namespace

void HorizonScore::add(const HorizonScore& other) {
  count += other.count;
  distance += other.distance;
  inside += other.inside;
}

double StretchScore::tracks_per_person() const {
  std::size_t count = 0;
  for (const auto& [person, followers] : tracks) count += followers.size();
  return static_cast<double>(count) / static_cast<double>(tracks.size());
}

void StretchScore::add(const StretchScore& other) {
  clear_mot.add(other.clear_mot);
  instants += other.instants;
  possible_at_misses += other.possible_at_misses;
  possible_elsewhere += other.possible_elsewhere;
  errors.insert(errors.end(), other.errors.begin(), other.errors.end());
  const std::uint32_t shift = tracks.empty() ? 0 : tracks.rbegin()->first + 1;
  for (const auto& [person, followers] : other.tracks) tracks[shift + person] = followers;
  for (const HorizonScore& horizon : other.horizons) {
    const auto same = std::ranges::find_if(
        horizons, [&](const HorizonScore& h) { return std::abs(h.ahead - horizon.ahead) < kSameTime; });
    if (same == horizons.end()) {
      horizons.push_back(horizon);
    } else {
      same->add(horizon);
    }
  }
  std::ranges::sort(horizons, {}, &HorizonScore::ahead);
}

StretchScore score_stretch(const std::vector<LabelledInstant>& labels,
                           const std::vector<TrackedSweep>& sweeps, const StretchOptions& options) {
  return StretchJudge(labels, sweeps, options).judge();
}

}  // namespace bw::people
