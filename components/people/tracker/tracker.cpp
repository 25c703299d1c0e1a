#include "components/people/tracker/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <utility>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "components/people/tracker/heading_track.hpp"
#include "components/people/tracker/leg_reassociation.hpp"
#include "components/people/tracker/reappearance.hpp"
#include "components/people/tracker/reporting.hpp"
#include "components/people/tracker/selection.hpp"
#include "components/people/tracker/tracker_impl.hpp"
#include "components/people/tracker/visibility.hpp"
#include "components/people/tracker/walking.hpp"

namespace bw::people {
namespace {

constexpr double kKeptOut = 0.25;         // confidence of who must not become background,
constexpr double kKeptOutByLooks = -2.0;  // log odds of the same, whatever else is about

}  // namespace

void Tracker::Impl::reset() {
  now_.reset();
  people_.clear();
  lost_.clear();
  clusters_.clear();
  walls_.reset();
  weighing_.reset();
  random_ = Random(1);
  reported_.clear();
  order_.reset();
  alignment_.reset();
  X_SO_ = {};
}

void Tracker::Impl::keep_out(std::vector<Vector2>& positions) const {
  const Pose2 X_OS = inverse(X_SO_);
  for (const PersonTrack& person : people_) {
    const Existence& existence = person.existence;
    const double itself = existence.log_odds() - existence.clutter - existence.alone;
    const bool is_known = existence.confidence() >= kKeptOut;
    if (!is_known && !person.hidden && itself >= kKeptOutByLooks)
      positions.push_back(X_OS * person.walker.position());
  }
}

/// A silence or a jump back forgets everybody.
void Tracker::Impl::begin_at(Time time) {
  const Duration gap = Duration::seconds(options_.kLongestGap);
  if (now_ && (time > *now_ + gap || time < *now_ - gap)) reset();
  if (!now_) origin_ = time;
}

void Tracker::Impl::predict_to(Time time) {
  const double dt = now_ ? (time - *now_).to_seconds() : 0.0;
  now_ = time;
  for (PersonTrack& person : people_) {
    person.walker.predict(dt, options_.walker);
    person.heading.predict(dt, options_.heading);
    for (double& unseen : person.unseen) unseen += dt;
    if (person.heard > 0.0) person.heard *= std::exp(-dt / options_.hearing.kMemory);
  }
  for (ClusterTrack& cluster : clusters_) cluster.predict(dt);
}

const std::vector<TrackedPerson>& Tracker::Impl::update(const DetectionSet& sweep) {
  begin_at(sweep.time);
  if (now_ && !order_.comes_next(sweep.source, sweep.time, *now_)) return reported_;
  const double since_own = order_.add(sweep.source, sweep.time, options_.kLongestGap);
  const double dt = now_ ? (sweep.time - *now_).to_seconds() : 0.0;
  ++sweep_;
  predict_to(sweep.time);
  transform_to_S(sweep);
  select_detections(sweep_in_S_, options_.kMaxDetections, options_.association, detections_);
  matching_.match(detections_, people_, clusters_, seconds(), options_.association);
  correct_clusters();
  correct_people();
  reassociate_legs();
  weighing_.remember(sweep_in_S_, seconds());
  weighing_.weigh(people_, clusters_, sweep_, seconds(), since_own, leading_sensor_, options_.birth);
  watch_for_absence(sweep_in_S_, since_own);
  follow_hidden_people(dt, since_own);
  initiate_tracks();
  leave_furniture();
  delete_tracks();
  report();
  return reported_;
}

void Tracker::Impl::transform_to_S(const DetectionSet& sweep) {
  bool is_new_leader = false;
  if (order_.leads(sweep.source, sweep.time, is_new_leader)) {
    if (is_new_leader) alignment_.reset();
    X_SO_ = X_SO_ * alignment_.align(sweep);
    leading_sensor_ = X_SO_ * sweep.sensor;
  }
  sweep_in_S_ = sweep;
  sweep_in_S_.sensor = X_SO_ * sweep.sensor;
  sweep_in_S_.angle_min = sweep.angle_min + X_SO_.theta;
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(X_SO_.theta).toRotationMatrix();
  for (Detection& d : sweep_in_S_.detections) {
    d.position = X_SO_ * d.position;
    d.covariance = (R * d.covariance * R.transpose()).eval();
  }
}

void Tracker::Impl::correct_person(PersonTrack& person, const LegMatch& match) {
  const bool one = (match.first < 0) != (match.second < 0);
  for (const auto& [part, index] :
       {std::pair{BodyPart::first_leg, match.first}, std::pair{BodyPart::second_leg, match.second}}) {
    if (index < 0) continue;
    const Detection& d = detections_[static_cast<std::size_t>(index)];
    const bool whole = one && d.body_score > d.leg_score;
    person.walker.correct(whole ? BodyPart::middle : part, d.position, d.covariance, options_.walker);
    person.score =
        options_.death.kScoreMemory * person.score + (1.0 - options_.death.kScoreMemory) * d.human_score();
    const Sighting seen = sighting_of(d);
    if (person.existence.prior == Existence::kUnseen) person.existence.prior = Existence::kOneLeg;
    if (person.last_seen != *now_) person.since_seen = (*now_ - person.last_seen).to_seconds();
    person.existence.appearance.add(seen.likeness(), seen.bearing, person.since_seen);
    person.last_seen = *now_;
    person.empty_seconds = 0.0;
    if (d.human_score() >= options_.hidden.kLikeness) person.sure = state_of(person);
    if (!d.on_static) person.free = state_of(person);
    const std::size_t leg = part == BodyPart::first_leg ? 0 : 1;
    if (whole) {
      person.unseen = {};
    } else {
      person.unseen[leg] = 0.0;
      person.remember_leg(leg, seen);
    }
  }
}

void Tracker::Impl::correct_people() {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    const LegMatch match = matching_.of_person(i);
    correct_heading(people_[i], match);
    correct_person(people_[i], match);
  }
}

/// Before the walker's correction: of one leg it tells how far that swings, as expected without this sweep.
void Tracker::Impl::correct_heading(PersonTrack& person, const LegMatch& match) {
  const auto detection = [&](int index) {
    return index < 0 ? nullptr : &detections_[static_cast<std::size_t>(index)];
  };
  const SeenLegs seen{detection(match.first), detection(match.second)};
  if (const auto middle = seen_middle(seen, person.walker, options_.heading))
    person.heading.correct(*middle, options_.heading);
}

Sighting Tracker::Impl::sighting_of(const Detection& d) const {
  const Vector2 seen_along = d.position - sweep_in_S_.sensor;
  return {.source = sweep_in_S_.source,
          .sweep = sweep_,
          .time = seconds(),
          .position = d.position,
          .variance = d.covariance.trace() / 2.0,
          .leg_score = d.leg_score,
          .body_score = d.body_score,
          .on_static = d.on_static,
          .occluded = d.occluded,
          .width = d.width,
          .bearing = std::atan2(seen_along.y(), seen_along.x())};
}

void Tracker::Impl::correct_clusters() {
  for (std::size_t i = 0; i < clusters_.size(); ++i) {
    const int j = matching_.of_cluster(i);
    if (j >= 0) clusters_[i].correct(sighting_of(detections_[static_cast<std::size_t>(j)]));
  }
  std::erase_if(clusters_, [&](const ClusterTrack& cluster) {
    return seconds() - cluster.last().time > options_.death.kClusterUnseen;
  });
  for (std::size_t j = 0; j < detections_.size(); ++j)
    if (!matching_.taken(j)) clusters_.emplace_back(sighting_of(detections_[j]));
}

/// What a person is known by from now on: two legs, or one, or both in one.
void Tracker::Impl::follow_legs(PersonTrack& person, const ClusterTrack& first,
                                const ClusterTrack* second) const {
  person.walker = walker_of(first, second, options_.walker);
  person.heading = heading_of(first, second, person.walker, options_.heading);
  person.last_seen = *now_;
  person.empty_seconds = 0.0;
  person.unseen = {};
  person.legs = {first, second == nullptr ? std::nullopt : std::optional(*second)};
  for (auto& leg : person.legs)
    if (leg) leg->id = 0;
  person.sure = person.settled = state_of(person);
  if (!first.last().on_static || person.free.time == 0.0) person.free = state_of(person);
  person.strayed = false;
  person.hidden.reset();
}

void Tracker::Impl::reassociate_legs() {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    if (people_[i].last_seen != *now_) continue;
    reassociate_legs_of({i});
    for (std::size_t j = i + 1; j < people_.size(); ++j) {
      const double distance = (people_[i].walker.position() - people_[j].walker.position()).norm();
      if (distance <= options_.leg_reassociation.kNear && people_[j].last_seen == *now_)
        reassociate_legs_of({i, j});
    }
  }
  for (PersonTrack& person : people_) {
    if (!person.both_legs_seen(sweep_)) continue;
    const auto doubt = doubt_of_legs(*person.legs[0], *person.legs[1], options_.leg_reassociation);
    if (doubt && *doubt < options_.leg_reassociation.kSettled) person.settled = state_of(person);
  }
}

void Tracker::Impl::reassociate_legs_of(std::initializer_list<std::size_t> of_people) {
  std::vector<const PersonTrack*> people;
  for (const std::size_t i : of_people) people.push_back(&people_[i]);
  auto pairs = people::reassociate_legs(people, clusters_, sweep_, options_.leg_reassociation);
  if (!pairs) return;
  std::size_t k = 0;
  for (const std::size_t i : of_people) {
    follow_legs(people_[i], pairs->legs[k][0], &pairs->legs[k][1]);
    ++k;
  }
  forget_clusters(pairs->taken);
  clusters_.insert(clusters_.end(), pairs->left.begin(), pairs->left.end());
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
          return seen_empty(sweep, person.walker.expected(part), options_.death.kMargin);
        });
    if (empty) person.empty_seconds += dt;
  }
}

void Tracker::Impl::follow_hidden_people(double dt, double since_own) {
  std::vector<Vector2> positions;
  for (const PersonTrack& person : people_) positions.push_back(person.walker.position());
  walls_.add(sweep_in_S_, seconds(), positions);
  const Surroundings about{sweep_in_S_, walls_, seconds(), dt, since_own};
  for (PersonTrack& person : people_)
    follow_hidden(person, about, is_told_of(person) || !is_out_of_sight(person), random_, options_);
  for (PersonTrack& person : lost_) follow_hidden(person, about, true, random_, options_);
}

/// Whoever walked and is believed no longer, since what they seem to be stood there before them, has walked
/// on unseen.
void Tracker::Impl::leave_furniture() {
  const auto is_furniture = [](const PersonTrack& person) {
    return person.existence.taken < Existence::kSurelyTaken && person.existence.log_odds() < 0.0;
  };
  for (const PersonTrack& person : people_) {
    if (!is_furniture(person)) continue;
    PersonTrack& strayed = lost_.emplace_back(person);
    strayed.sure = person.free;
    strayed.strayed = true;
    strayed.existence.taken = 0.0;
    strayed.hidden.reset();
  }
  std::erase_if(people_, is_furniture);
}

void Tracker::Impl::delete_tracks() {
  const DeathOptions& death = options_.death;
  const auto gone = [&](const PersonTrack& person) {
    const bool is_of_others = person.heard > 0.0 && person.last_heard > person.last_seen;
    if (is_told_of(person)) return person.walker.position_sigma() > death.sigma;
    if (is_of_others && person.heard < ExternalDetectionOptions::kForgotten) return true;
    return person.empty_seconds >= death.unseen - 1e-9 || person.walker.position_sigma() > death.sigma ||
           person.there < options_.hidden.kBelieved ||
           (person.score < death.kUnlikeScore && person.walker.velocity().norm() < death.kUnlikeSpeed);
  };
  std::ranges::copy_if(people_, std::back_inserter(lost_), gone);
  std::erase_if(people_, gone);
  const Duration remembered = Duration::seconds(options_.hidden.kRemembered);
  std::erase_if(lost_, [&](const PersonTrack& person) {
    const Duration stood = std::max(remembered, Duration::seconds(HiddenOptions::kStoodRemembered));
    return *now_ > person.last_known() + (person.stood() ? stood : remembered);
  });
  if (lost_.size() > HiddenOptions::kMaxLost)  // who was let go last stays
    lost_.erase(lost_.begin(), lost_.end() - static_cast<std::ptrdiff_t>(HiddenOptions::kMaxLost));
}

/// Somebody new keeps the id by which a part of them was told of.
std::uint32_t Tracker::Impl::id_of(const ClusterTrack& first, const ClusterTrack* second) {
  if (first.id != 0) return first.id;
  return second != nullptr && second->id != 0 ? second->id : ++last_id_;
}

void Tracker::Impl::initiate_tracks() {
  find_people(clusters_, sweep_, options_.birth, candidates_);
  std::vector<int> used;
  for (const Candidate& candidate : candidates_) {
    const ClusterTrack& first = clusters_[static_cast<std::size_t>(candidate.first)];
    const ClusterTrack* second =
        candidate.second < 0 ? nullptr : &clusters_[static_cast<std::size_t>(candidate.second)];
    used.push_back(candidate.first);
    if (second != nullptr) used.push_back(candidate.second);
    const Sighting& oldest = first.sighting(first.remembered() - 1);
    const Walker walker = walker_of(first, second, options_.walker);
    std::optional<PersonTrack> person;
    if (candidate.birth.stands()) person = take_who_stood(people_, lost_, walker.position());
    const bool was_here = person.has_value();
    if (!person)
      person = take_returned(people_, lost_, oldest, walker.velocity(), seconds(), options_.hidden);
    Existence existence = existence_of(candidate.birth, first, second);
    if (person) {
      if (!was_here) person->foot_shifts = {};
    } else {
      person = PersonTrack{.id = id_of(first, second),
                           .walker = walker,
                           .born = origin_ + Duration::seconds(oldest.time),
                           .confirmed = *now_};
    }
    weighing_.weigh_surroundings(stood(&first, second, options_.birth), existence);
    existence.keep_belief();
    person->existence = existence;
    person->score = first.last().human_score();
    follow_legs(*person, first, second);
    people_.insert(std::ranges::upper_bound(people_, person->id, {}, &PersonTrack::id), *person);
  }
  forget_clusters(used);
}

void Tracker::Impl::report() {
  reported_.clear();
  const Pose2 X_OS = inverse(X_SO_);
  for (const PersonTrack& person : people_)
    reported_.push_back(report_of(person, X_OS, options_.kPersonRadius));
  for (ClusterTrack& cluster : clusters_) {
    if (!may_be_somebody(cluster)) continue;
    if (cluster.id == 0) cluster.id = ++last_id_;
    reported_.push_back(report_of(cluster, origin_, X_OS, options_.kPersonRadius));
  }
  std::ranges::sort(reported_, {}, &TrackedPerson::id);
}

Tracker::Tracker(const TrackerOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Tracker::~Tracker() = default;

void Tracker::set_options(const TrackerOptions& options) { impl_->set_options(options); }

const std::vector<TrackedPerson>& Tracker::update(const DetectionSet& sweep) { return impl_->update(sweep); }
const std::vector<TrackedPerson>& Tracker::hear(const HeardSet& heard) { return impl_->hear(heard); }
const std::vector<TrackedPerson>& Tracker::people() const { return impl_->people(); }
std::size_t Tracker::cluster_count() const { return impl_->cluster_count(); }
void Tracker::reset() { impl_->reset(); }

std::vector<Vector2> Tracker::keep_out() const {
  std::vector<Vector2> positions;
  for (const TrackedPerson& person : people())
    if (person.confidence >= kKeptOut) positions.push_back(person.position);
  impl_->keep_out(positions);
  return positions;
}

}  // namespace bw::people
