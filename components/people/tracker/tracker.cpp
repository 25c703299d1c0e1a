#include "components/people/tracker/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "components/people/tracker/birth.hpp"
#include "components/people/tracker/cluster_track.hpp"
#include "components/people/tracker/heading_track.hpp"
#include "components/people/tracker/matching.hpp"
#include "components/people/tracker/person_track.hpp"
#include "components/people/tracker/reappearance.hpp"
#include "components/people/tracker/sweep_alignment.hpp"
#include "components/people/tracker/untangle.hpp"
#include "components/people/tracker/visibility.hpp"

namespace bw::people {
namespace {

double human_score(const Detection& d) { return std::max(d.leg_score, d.body_score); }

constexpr double kLargestVariance = 2.0;  // [m^2] of a place that says anything

bool usable(const Detection& d, const AssociationOptions& options) {
  const Eigen::Matrix2d& c = d.covariance;
  return d.position.allFinite() && c.allFinite() && c(0, 0) > 0.0 && c.determinant() > 0.0 &&
         std::abs(c(0, 1) - c(1, 0)) <= 1e-6 * c.trace() && c.trace() <= kLargestVariance &&

         d.leg_score >= 0.0 && d.leg_score <= 1.0 && d.body_score >= 0.0 && d.body_score <= 1.0 &&
         d.width <= options.largest;
}

struct Motion {
  Vector2 position;
  Vector2 velocity;
  Eigen::Matrix4d covariance;
};

Motion motion_of(const PersonTrack& person) {
  const auto of = [](const auto& filter) {
    return Motion{filter.position(), filter.velocity(), filter.covariance()};
  };
  return person.heading ? of(*person.heading) : of(person.walker);
}

}  // namespace

class Tracker::Impl {
 public:
  explicit Impl(const TrackerOptions& options) : options_(options), alignment_(options.alignment) {}

  const std::vector<TrackedPerson>& update(const DetectionSet& sweep);
  const std::vector<TrackedPerson>& people() const { return reported_; }
  std::size_t cluster_count() const { return clusters_.size(); }
  void reset();

 private:
  void to_S(const DetectionSet& sweep);
  void take_in(const DetectionSet& sweep);
  void correct_people();
  LegMatch possible(PersonTrack& person, LegMatch match);
  void correct_heading(PersonTrack& person, const LegMatch& match);
  void correct_person(PersonTrack& person, const LegMatch& match);
  void correct_clusters();
  void untangle();
  void pair_legs_anew(const std::vector<PersonTrack*>& people);
  void forget_clusters(std::vector<int>& used);
  Sighting sighting_of(const Detection& d) const;
  PastState state_of(const PersonTrack& person) const {
    return {(*now_ - origin_).to_seconds(), person.walker.position(), person.walker.velocity()};
  }
  void remember_leg(std::optional<ClusterTrack>& leg, const Detection& d) const;
  void watch_for_absence(const DetectionSet& sweep, double dt);
  void lose_people();
  void give_missing_legs_back();
  void find_new_people();
  std::optional<PersonTrack> take_lost(const ClusterTrack& appeared);
  void report();

  TrackerOptions options_;
  SweepAlignment alignment_;
  Pose2 X_SO_;  ///< S: odom without its errors from sweep to sweep; tracks live in S
  DetectionSet sweep_in_S_;
  std::optional<Time> now_;
  Time origin_;
  std::int64_t sweep_ = 0;
  std::uint32_t last_id_ = 0;
  std::vector<PersonTrack> people_;
  std::vector<PersonTrack> lost_;  ///< let go lately
  std::vector<ClusterTrack> clusters_;
  std::vector<Detection> detections_;
  Matching matching_;
  std::vector<Candidate> candidates_;
  std::vector<TrackedPerson> reported_;
};

void Tracker::Impl::reset() {
  now_.reset();
  people_.clear();
  lost_.clear();
  clusters_.clear();
  reported_.clear();
  alignment_.reset();
  X_SO_ = {};
}

const std::vector<TrackedPerson>& Tracker::Impl::update(const DetectionSet& sweep) {
  const Duration gap = Duration::seconds(options_.longest_gap);
  if (now_ && (sweep.time > *now_ + gap || sweep.time < *now_ - gap)) reset();
  if (now_ && sweep.time <= *now_) return reported_;
  if (!now_) origin_ = sweep.time;
  const double dt = now_ ? (sweep.time - *now_).to_seconds() : 0.0;
  now_ = sweep.time;
  ++sweep_;

  to_S(sweep);
  take_in(sweep_in_S_);
  for (PersonTrack& person : people_) {
    person.walker.predict(dt, options_.walker);
    if (person.heading) person.heading->predict(dt, options_.heading);
  }
  for (ClusterTrack& cluster : clusters_) cluster.predict(dt);
  matching_.match(detections_, people_, clusters_, sweep_, options_.association);
  correct_clusters();
  correct_people();
  untangle();
  watch_for_absence(sweep_in_S_, dt);
  give_missing_legs_back();
  find_new_people();
  lose_people();
  report();
  return reported_;
}

void Tracker::Impl::to_S(const DetectionSet& sweep) {
  X_SO_ = X_SO_ * alignment_.align(sweep);
  sweep_in_S_ = sweep;
  sweep_in_S_.sensor = X_SO_ * sweep.sensor;
  sweep_in_S_.angle_min = sweep.angle_min + X_SO_.theta;
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(X_SO_.theta).toRotationMatrix();
  for (Detection& d : sweep_in_S_.detections) {
    d.position = X_SO_ * d.position;
    d.covariance = (R * d.covariance * R.transpose()).eval();
  }
}

void Tracker::Impl::take_in(const DetectionSet& sweep) {
  detections_.clear();
  for (const Detection& d : sweep.detections) {
    if (!usable(d, options_.association)) continue;
    detections_.push_back(d);
    const double vague = options_.association.vague * (1.0 - human_score(d));
    detections_.back().covariance += vague * vague * Eigen::Matrix2d::Identity();
  }
  const auto most = static_cast<std::size_t>(options_.most_detections);
  if (detections_.size() <= most) return;
  std::stable_sort(detections_.begin(), detections_.end(),
                   [](const Detection& a, const Detection& b) { return human_score(a) > human_score(b); });
  detections_.resize(most);
}

void Tracker::Impl::correct_person(PersonTrack& person, const LegMatch& match) {
  ++person.first_unseen;
  ++person.second_unseen;
  const bool one = (match.first < 0) != (match.second < 0);
  for (const auto& [part, index] :
       {std::pair{BodyPart::first_leg, match.first}, std::pair{BodyPart::second_leg, match.second}}) {
    if (index < 0) continue;
    const Detection& d = detections_[static_cast<std::size_t>(index)];
    const bool whole = one && d.body_score > d.leg_score;
    person.walker.correct(whole ? BodyPart::middle : part, d.position, d.covariance, options_.walker);
    person.score =
        options_.death.score_memory * person.score + (1.0 - options_.death.score_memory) * human_score(d);
    person.last_seen = *now_;
    person.empty_seconds = 0.0;
    if (human_score(d) >= options_.back.likeness) person.sure = state_of(person);
    if (!whole) remember_leg(person.legs[part == BodyPart::first_leg ? 0 : 1], d);
    if (whole || part == BodyPart::first_leg) person.first_unseen = 0;
    if (whole || part == BodyPart::second_leg) person.second_unseen = 0;
  }
}

void Tracker::Impl::correct_people() {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    const LegMatch match = possible(people_[i], matching_.of_person(i));
    correct_heading(people_[i], match);
    correct_person(people_[i], match);
  }
}

/// Before the walker's correction: of one leg it tells how far that swings, as expected without this sweep.
void Tracker::Impl::correct_heading(PersonTrack& person, const LegMatch& match) {
  if (!person.heading) return;
  const auto detection = [&](int index) {
    return index < 0 ? nullptr : &detections_[static_cast<std::size_t>(index)];
  };
  const SeenLegs seen{detection(match.first), detection(match.second)};
  if (const auto middle = seen_middle(seen, person.walker, options_.heading))
    person.heading->correct(*middle, options_.heading);
}

/// Two legs farther apart than legs can be belong to two people: keeps the one that was foreseen better.
LegMatch Tracker::Impl::possible(PersonTrack& person, LegMatch match) {
  if (match.first < 0 || match.second < 0) return match;
  const Detection& first = detections_[static_cast<std::size_t>(match.first)];
  const Detection& second = detections_[static_cast<std::size_t>(match.second)];
  if ((first.position - second.position).norm() <= options_.association.separation) return match;
  const double miss_first = (first.position - person.walker.expected(BodyPart::first_leg)).norm();
  const double miss_second = (second.position - person.walker.expected(BodyPart::second_leg)).norm();
  const bool first_wrong = miss_first > miss_second;
  int& wrong = first_wrong ? match.first : match.second;
  std::optional<ClusterTrack>& leg = person.legs[first_wrong ? 0 : 1];
  remember_leg(leg, first_wrong ? first : second);
  clusters_.push_back(*leg);  // nobody's, with what was seen of it
  leg.reset();
  wrong = -1;
  return match;
}

Sighting Tracker::Impl::sighting_of(const Detection& d) const {
  return {.sweep = sweep_,
          .time = (*now_ - origin_).to_seconds(),
          .position = d.position,
          .variance = d.covariance.trace() / 2.0,
          .leg_score = d.leg_score,
          .body_score = d.body_score,
          .on_static = d.on_static,
          .occluded = d.occluded};
}

void Tracker::Impl::correct_clusters() {
  for (std::size_t i = 0; i < clusters_.size(); ++i) {
    const int j = matching_.of_cluster(i);
    if (j >= 0) clusters_[i].correct(sighting_of(detections_[static_cast<std::size_t>(j)]));
  }
  const double now = (*now_ - origin_).to_seconds();
  std::erase_if(clusters_, [&](const ClusterTrack& cluster) {
    return now - cluster.last().time > options_.death.cluster_unseen;
  });
  for (std::size_t j = 0; j < detections_.size(); ++j)
    if (!matching_.taken(j)) clusters_.emplace_back(sighting_of(detections_[j]));
}

void Tracker::Impl::remember_leg(std::optional<ClusterTrack>& leg, const Detection& d) const {
  constexpr double kStep = 0.45;  // [m] no leg does more from one sweep to the next
  const bool same =
      leg && leg->last().sweep + 3 >= sweep_ && (leg->last().position - d.position).norm() < kStep;
  if (same) {
    leg->correct(sighting_of(d));
  } else {
    leg.emplace(sighting_of(d));
  }
}

void Tracker::Impl::untangle() {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    if (people_[i].last_seen != *now_) continue;
    pair_legs_anew({&people_[i]});
    for (std::size_t j = i + 1; j < people_.size(); ++j) {
      const double distance = (people_[i].walker.position() - people_[j].walker.position()).norm();
      if (distance <= options_.untangle.near && people_[j].last_seen == *now_)
        pair_legs_anew({&people_[i], &people_[j]});
    }
  }
  for (PersonTrack& person : people_) {
    const auto& [first, second] = person.legs;
    if (!first || !second || first->last().sweep != sweep_ || second->last().sweep != sweep_) continue;
    const auto doubt = doubt_of_legs(*first, *second, options_.untangle);
    if (doubt && *doubt < options_.untangle.settled) person.settled = state_of(person);
  }
}

void Tracker::Impl::pair_legs_anew(const std::vector<PersonTrack*>& people) {
  std::vector<const ClusterTrack*> strangers;
  for (const ClusterTrack& cluster : clusters_) {
    const Sighting& last = cluster.last();
    if (last.sweep != sweep_ || last.leg_score < options_.birth.walking_score || strangers.size() >= 4)
      continue;
    const auto near = [&](const PersonTrack* person) {
      return (last.position - person->walker.position()).norm() <= options_.association.separation;
    };
    if (std::ranges::any_of(people, near)) strangers.push_back(&cluster);
  }
  const std::vector<LegPair> pairs =
      better_pairs({people.begin(), people.end()}, strangers, sweep_, options_.untangle);
  if (pairs.empty()) return;

  const auto chosen = [&](const ClusterTrack* leg) {
    return std::ranges::any_of(pairs, [&](const LegPair& pair) { return pair[0] == leg || pair[1] == leg; });
  };
  std::vector<ClusterTrack> left;  // legs that are nobody's now
  for (const PersonTrack* person : people)
    for (const auto& leg : person->legs)
      if (leg && leg->last().sweep == sweep_ && !chosen(&*leg)) left.push_back(*leg);
  std::vector<int> used;
  for (const ClusterTrack* stranger : strangers)
    if (chosen(stranger)) used.push_back(static_cast<int>(stranger - clusters_.data()));
  std::vector<std::array<ClusterTrack, 2>> legs;
  for (const LegPair& pair : pairs) legs.push_back({*pair[0], *pair[1]});
  for (std::size_t i = 0; i < people.size(); ++i) {
    PersonTrack& person = *people[i];
    person.walker = walker_of(legs[i][0], &legs[i][1], options_.walker);
    if (person.heading) person.heading = heading_of(legs[i][0], &legs[i][1], person.walker, options_.heading);
    person.legs = {legs[i][0], legs[i][1]};
    person.last_seen = *now_;
    person.empty_seconds = 0.0;
    person.first_unseen = person.second_unseen = 0;
    person.sure = person.settled = state_of(person);
  }
  forget_clusters(used);
  clusters_.insert(clusters_.end(), left.begin(), left.end());
}

void Tracker::Impl::forget_clusters(std::vector<int>& used) {
  std::sort(used.begin(), used.end(), std::greater<>());
  for (const int i : used) clusters_.erase(clusters_.begin() + i);
}

/// Who is not seen counts the time for which the laser looks through all of where they should be.
void Tracker::Impl::watch_for_absence(const DetectionSet& sweep, double dt) {
  for (PersonTrack& person : people_) {
    if (person.last_seen == *now_) continue;
    const bool empty = std::ranges::all_of(
        std::initializer_list<BodyPart>{BodyPart::first_leg, BodyPart::second_leg, BodyPart::middle},
        [&](BodyPart part) {
          return seen_empty(sweep, person.walker.expected(part), options_.death.margin);
        });
    if (empty) person.empty_seconds += dt;
  }
}

void Tracker::Impl::lose_people() {
  const DeathOptions& death = options_.death;
  const auto gone = [&](const PersonTrack& person) {
    return person.empty_seconds >= death.unseen - 1e-9 || person.walker.position_sigma() > death.sigma ||
           (person.score < death.unlike_score && person.walker.velocity().norm() < death.unlike_speed);
  };
  std::ranges::copy_if(people_, std::back_inserter(lost_), gone);
  std::erase_if(people_, gone);
  const Duration remembered = Duration::seconds(options_.back.remembered);
  std::erase_if(lost_, [&](const PersonTrack& person) { return *now_ > person.last_seen + remembered; });
}

/// A leg that came back outside of its gate has become a cluster meanwhile: the person takes it back.
void Tracker::Impl::give_missing_legs_back() {
  constexpr int kMissing = 3;
  for (PersonTrack& person : people_) {
    const bool first = person.first_unseen >= kMissing && person.second_unseen == 0;
    const bool second = person.second_unseen >= kMissing && person.first_unseen == 0;
    if (first == second) continue;
    const Vector2 seen = person.walker.expected(first ? BodyPart::second_leg : BodyPart::first_leg);
    auto nearest = clusters_.end();
    double best = options_.birth.separation;
    for (auto cluster = clusters_.begin(); cluster != clusters_.end(); ++cluster) {
      const Sighting& last = cluster->last();
      if (last.sweep != sweep_ || last.leg_score < options_.birth.walking_score) continue;
      if (cluster->remembered() < options_.birth.sightings) continue;
      if ((cluster->velocity() - person.walker.velocity()).norm() >
          0.5 + 1.2 * person.walker.velocity().norm())
        continue;
      const double distance = (last.position - seen).norm();
      if (distance >= best) continue;
      best = distance;
      nearest = cluster;
    }
    if (nearest == clusters_.end()) continue;
    const Sighting& last = nearest->last();
    person.walker.forget_legs(options_.walker);
    const BodyPart missing = first ? BodyPart::first_leg : BodyPart::second_leg;
    person.walker.correct(missing, last.position, last.variance * Eigen::Matrix2d::Identity(),
                          options_.walker);
    (first ? person.first_unseen : person.second_unseen) = 0;
    clusters_.erase(nearest);
  }
}

/// Takes out whoever was lost, or is not seen in this sweep, and most likely is who appeared.
std::optional<PersonTrack> Tracker::Impl::take_lost(const ClusterTrack& appeared) {
  const Sighting& first = appeared.sighting(appeared.remembered() - 1);
  const double now = (*now_ - origin_).to_seconds();
  std::vector<PersonTrack>* from = nullptr;
  std::size_t likeliest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::vector<PersonTrack>* among : {&people_, &lost_}) {
    for (std::size_t i = 0; i < among->size(); ++i) {
      const PersonTrack& person = (*among)[i];
      if (among == &people_ && now - person.sure.time < options_.back.absent) continue;
      const auto doubt = doubt_of_return(person, first.position, first.time, options_.back);
      if (!doubt || *doubt >= least) continue;
      least = *doubt;
      from = among;
      likeliest = i;
    }
  }
  if (from == nullptr) return std::nullopt;
  const auto place = from->begin() + static_cast<std::ptrdiff_t>(likeliest);
  const PersonTrack person = *place;
  from->erase(place);
  return person;
}

void Tracker::Impl::find_new_people() {
  find_people(clusters_, sweep_, options_.birth, candidates_);
  std::vector<int> used;
  for (const Candidate& candidate : candidates_) {
    const ClusterTrack& first = clusters_[static_cast<std::size_t>(candidate.first)];
    const ClusterTrack* second =
        candidate.second < 0 ? nullptr : &clusters_[static_cast<std::size_t>(candidate.second)];
    const Walker walker = walker_of(first, second, options_.walker);
    used.push_back(candidate.first);
    if (second != nullptr) used.push_back(candidate.second);
    std::optional<PersonTrack> known = take_lost(first);
    if (!known) {
      const Sighting& oldest = first.sighting(first.remembered() - 1);
      known = PersonTrack{.id = ++last_id_,
                          .walker = walker,
                          .born = origin_ + Duration::seconds(oldest.time),
                          .confirmed = *now_};
    }
    known->walker = walker;
    known->score = first.last().human_score();
    if (options_.motion == "heading") known->heading = heading_of(first, second, walker, options_.heading);
    known->last_seen = *now_;
    known->empty_seconds = 0.0;
    known->sure = known->settled = state_of(*known);
    known->legs = {first, second == nullptr ? std::nullopt : std::optional(*second)};
    known->first_unseen = 0;
    known->second_unseen = second == nullptr ? 1 : 0;
    people_.insert(std::ranges::upper_bound(people_, known->id, {}, &PersonTrack::id), *known);
  }
  forget_clusters(used);
}

void Tracker::Impl::report() {
  reported_.clear();
  const Pose2 X_OS = inverse(X_SO_);
  Eigen::Matrix4d R = Eigen::Matrix4d::Zero();
  R.topLeftCorner<2, 2>() = R.bottomRightCorner<2, 2>() = Eigen::Rotation2Dd(X_OS.theta).toRotationMatrix();
  for (const PersonTrack& person : people_) {
    const double unseen = (*now_ - person.last_seen).to_seconds();
    const auto [position, velocity, covariance] = motion_of(person);
    reported_.push_back({.id = person.id,
                         .position = X_OS * position,
                         .velocity = rotate(X_OS, velocity),
                         .covariance = R * covariance * R.transpose(),
                         .radius = options_.person_radius,
                         .confidence = person.score * std::exp(-unseen / options_.death.unseen),
                         .born = person.born,
                         .confirmed = person.confirmed,
                         .last_seen = person.last_seen});
  }
}

Tracker::Tracker(const TrackerOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Tracker::~Tracker() = default;

const std::vector<TrackedPerson>& Tracker::update(const DetectionSet& sweep) { return impl_->update(sweep); }
const std::vector<TrackedPerson>& Tracker::people() const { return impl_->people(); }
std::size_t Tracker::cluster_count() const { return impl_->cluster_count(); }
void Tracker::reset() { impl_->reset(); }

std::vector<Vector2> Tracker::keep_out() const {
  std::vector<Vector2> places;
  for (const TrackedPerson& person : people()) places.push_back(person.position);
  return places;
}

}  // namespace bw::people
