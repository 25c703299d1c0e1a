#include "components/people/tracker/weighing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "components/people/tracker/walking.hpp"

namespace bw::people {
namespace {

constexpr double kPostAge = 0.5;  // [s] what has stood so long is a post
constexpr double kStill = 0.15;   // [m] its positions differ less
constexpr double kThin = 0.25;    // [m] and it is less wide
constexpr double kReach = 2.5;    // [m] farther furniture is not theirs: the diagonal of a table and more
constexpr double kSlowly = 1.0;   // [s] in which patterns gain and lose belief
constexpr FootShifts::Memory kOfLeg{.gap = 0.5, .bearing_change = 0.1};
// However long it is out of view, and from every side: measured on furniture, README.
constexpr FootShifts::Memory kOfPair{.gap = 1e9, .bearing_change = 4.0};
constexpr double kSensorStill = 0.05;   // [m] a laser that moves less stands
constexpr double kSensorStood = 1.0;    // [s]
constexpr double kLooksOfShifts = 2.0;  // log odds of a pair whose shifts count
constexpr double kThinnest = 0.07;      // [m] leg whose shifts count,
constexpr double kAlike = 0.05;  // [m] and by how much the two differ at most: leaves and bars part and merge
constexpr double kLookUpEvery = 1.0;       // [s] what was at a position before is looked up so often,
constexpr double kLookedUpWithin = 0.1;    // [m] or when a thing has moved so far
constexpr double kTaken = -14.0;           // log odds of legs that stand where something stood before
constexpr double kClutterGain = 0.3;       // [s] in which things that come into view are noticed
constexpr double kClutterMemory = 10.0;    // [s] in which things out of view are forgotten
constexpr double kFurnitureMemory = 60.0;  // [s] in which a place is no longer taken for a furnished one
constexpr double kSettled = 2.0;           // [s] after which furniture about two legs has been noticed
constexpr double kNoFurniture = 2.0;       // things that look like legs; legs count until they are somebody's
constexpr double kLegsOfSomebody = 3.0;    // so many may still be those of people who stand about
constexpr double kFurnished = 3.0;         // more of them make a furnished place
constexpr double kCompanyMemory = 30.0;    // [s] in which people who have left are forgotten
constexpr double kSomebody = 0.5;          // people known: one who walked about within 20 s
constexpr double kOfOneLeg = 0.5;          // share of what shifts say where no other leg is seen
constexpr double kNoticed = 1.0;           // [s] after which what stands is told of
constexpr double kLeastLooks = -0.5;
constexpr double kFurniture = -6.0;  // log odds of what is no longer told of

using Past = PastSweeps::Past;

bool stands(const ClusterTrack& thing) {
  const Sighting& oldest = thing.sighting(thing.remembered() - 1);
  return thing.last().time - thing.born() >= kPostAge &&
         (thing.last().position - oldest.position).norm() < kStill;
}

bool is_post(const ClusterTrack& thing, std::int64_t sweep) {
  return thing.last().sweep == sweep && thing.last().width <= kThin && stands(thing);
}

Post post_of(const ClusterTrack& thing) { return {thing.last().position, thing.last().width}; }

double prior_of(BirthKind kind) {
  switch (kind) {
    case BirthKind::walking_pair:
      return Existence::kWalker;
    case BirthKind::walking_single:
      return Existence::kLoneWalker;
    case BirthKind::standing_pair:
      return Existence::kTwoLegs;
    case BirthKind::standing_single:
      break;
  }
  return Existence::kOneLeg;
}

/// Of the legs that are seen; `other` may be null.
double share_that_came(Past one, const Past* other) {
  const int came = (one == Past::empty ? 1 : 0) + (other != nullptr && *other == Past::empty ? 1 : 0);
  if (came == 0) return 0.0;
  return other == nullptr || came == 2 ? 1.0 : Existence::kOneCame;
}

}  // namespace

std::optional<double> stood(const ClusterTrack* one, const ClusterTrack* other, const BirthOptions& options) {
  if (one == nullptr || other == nullptr || !stays(*one, *other, options)) return std::nullopt;
  return std::min(one->last().time - one->born(), other->last().time - other->born());
}

Existence existence_of(const Birth& birth, const ClusterTrack& first, const ClusterTrack* second) {
  Existence existence = first.existence;
  existence.walked.distance = birth.distance;
  existence.prior = prior_of(birth.kind);
  if (second != nullptr) {
    if (second->existence.appearance.log_odds() < existence.appearance.log_odds())
      existence.appearance = second->existence.appearance;
    existence.foot_shifts = std::max(existence.foot_shifts, second->existence.foot_shifts);
    existence.row = std::min(existence.row, second->existence.row);
    existence.came = Existence::kCame * share_that_came(first.past, &second->past);
  }
  return existence;
}

bool may_be_somebody(const ClusterTrack& cluster) {
  if (cluster.id != 0) return cluster.existence.log_odds() > kFurniture;
  return cluster.last().time - cluster.born() >= kNoticed && stands(cluster) && !cluster.last().on_static &&
         cluster.existence.appearance.log_odds() >= kLeastLooks;
}

void Weighing::reset() {
  past_.reset();
  clutter_ = 0.0;
  furniture_ = 0.0;
  company_ = 0.0;
  stood_ = {0.0, 0.0};
  standing_since_ = 0.0;
  still_ = false;
}

void Weighing::find_posts(const std::vector<PersonTrack>& people, const std::vector<ClusterTrack>& clusters,
                          std::int64_t sweep) {
  posts_.clear();
  for (const ClusterTrack& cluster : clusters)
    if (is_post(cluster, sweep)) posts_.push_back(post_of(cluster));
  for (const PersonTrack& person : people) {
    if (person.existence.walked.distance >= Walked::kFree) continue;
    for (const auto& leg : person.legs)
      if (leg && is_post(*leg, sweep)) posts_.push_back(post_of(*leg));
  }
}

double Weighing::row_at(const ClusterTrack& thing, const ClusterTrack* other) {
  near_.clear();
  const Post post = post_of(thing);
  for (const Post& another : posts_) {
    const bool own =
        another.position == post.position || (other && another.position == other->last().position);
    if (!own && (another.position - post.position).squaredNorm() < kReach * kReach) near_.push_back(another);
  }
  return row_of_posts(post, near_).log_odds;
}

void Weighing::weigh_cluster(ClusterTrack& cluster, double gain) {
  const Sighting& seen = cluster.last();
  // Another laser sees it a little elsewhere: that is no fidget.
  if (still_ && seen.source == cluster.source())
    cluster.foot_shifts.add(seen.time, seen.position, !seen.occluded, seen.bearing, kOfLeg);
  cluster.existence.foot_shifts = kOfOneLeg * cluster.foot_shifts.log_odds();
  if (cluster.existence.appearance.log_odds() > kLeastLooks && seen.width <= kThin && stands(cluster))
    cluster.existence.row += gain * (row_at(cluster, nullptr) - cluster.existence.row);
}

double Weighing::furnished_beyond(double things) const {
  return std::clamp((furniture_ - things) / kFurnished, 0.0, 1.0);
}

/// Who stands where somebody walks and nothing else looks like a leg is not taken for furniture for long.
double Weighing::alone_of(double stood) const {
  const bool undecided = stood < kSettled || company_ < kSomebody;
  const double share = undecided ? 1.0 : furnished_beyond(kNoFurniture);
  return std::min(Existence::kMaxCompany,
                  share * Existence::kAlone + Existence::kCompany * std::log1p(company_));
}

void Weighing::weigh_surroundings(std::optional<double> stood, Existence& existence) const {
  existence.furnished = furnished_beyond(kLegsOfSomebody);
  existence.clutter = existence.alone = 0.0;
  if (existence.walked.distance >= Walked::kFree || existence.came >= Existence::kHasCome) return;
  const double others = std::max(0.0, clutter_ - 1.0);
  if (existence.prior == Existence::kWalker) existence.clutter = Existence::kEachOtherWalking * others;
  if (existence.prior != Existence::kTwoLegs) return;
  existence.clutter = Existence::kEachOther * others / (1.0 + Existence::kShareOfOthers * company_);
  if (stood) existence.alone = alone_of(*stood);
}

/// In view, and walkers beyond doubt.
void Weighing::count_company(const std::vector<PersonTrack>& people, double dt) {
  const auto known = static_cast<double>(std::ranges::count_if(people, [](const PersonTrack& person) {
    return !person.hidden && person.existence.walked.distance >= Walked::kFree &&
           person.existence.log_odds() > 0.0;
  }));
  company_ += (known > company_ ? 1.0 : std::min(1.0, dt / kCompanyMemory)) * (known - company_);
}

void Weighing::look_up(ClusterTrack& thing, double now) const {
  const Vector2& position = thing.last().position;
  const double moved = (position - thing.looked_up_at).norm();
  if (thing.past == Past::empty && moved < kStill) return;
  if (moved < kLookedUpWithin && now - thing.looked_up < kLookUpEvery) return;
  thing.looked_up_at = position;
  thing.looked_up = now;
  thing.past = past_.at(position, now);
}

void Weighing::weigh_coming(PersonTrack& person, std::int64_t sweep, double now) const {
  const Past* seen[2] = {nullptr, nullptr};
  for (auto& leg : person.legs) {
    if (!leg || leg->last().sweep != sweep) continue;
    look_up(*leg, now);
    seen[seen[0] == nullptr ? 0 : 1] = &leg->past;
  }
  if (seen[0] == nullptr) return;
  Existence& existence = person.existence;
  existence.in_place = *seen[0] == Past::occupied && (seen[1] == nullptr || *seen[1] == Past::occupied);
  existence.came = Existence::kCame * share_that_came(*seen[0], seen[1]) *
                   (1.0 - existence.taken / kTaken);  // background says otherwise
}

void Weighing::weigh_rigidity(PersonTrack& person, std::int64_t sweep, double dt) {
  Existence& existence = person.existence;
  if (existence.has_moved()) {
    existence.rigid = 0.0;
  } else if (person.both_legs_seen(sweep)) {
    existence.rigid = std::max(Existence::kMaxRigid, existence.rigid + Existence::kRigid * dt);
  }
}

/// Nothing becomes background where somebody walks up to: what is background under their feet is not theirs.
void Weighing::weigh_position(PersonTrack& person, std::int64_t sweep, double gain) {
  if (person.existence.walked.distance < Walked::kFree) return;
  double seen = 0.0;
  double on_background = 0.0;
  for (const auto& leg : person.legs) {
    if (!leg || leg->last().sweep != sweep) continue;
    seen += 1.0;
    on_background += leg->last().on_static ? 1.0 : 0.0;
  }
  if (seen == 0.0) return;
  person.existence.taken += gain * (kTaken * on_background / seen - person.existence.taken);
}

/// Who stands on two legs leans: one of them is hidden by the other often, and so is the path between them.
double Weighing::shifts_of_legs(PersonTrack& person, std::int64_t sweep) const {
  double most = 0.0;
  for (auto& leg : person.legs) {
    const Sighting& seen = leg->last();
    if (still_ && seen.sweep == sweep && seen.source == leg->source())
      leg->foot_shifts.add(seen.time, seen.position, !seen.occluded, seen.bearing, kOfLeg);
    most = std::max(most, kOfOneLeg * leg->foot_shifts.log_odds());
  }
  return most;
}

void Weighing::weigh_person(PersonTrack& person, std::int64_t sweep, double dt, double gain,
                            const BirthOptions& options) {
  Existence& existence = person.existence;
  const bool both = person.both_legs_seen(sweep);
  std::optional<Walk> walk;
  if (both) {
    walk = walk_of_pair(*person.legs[0], *person.legs[1], options);
  } else {
    for (const auto& leg : person.legs)
      if (leg && leg->last().sweep == sweep) walk = walk_of_single(*leg, options);
  }
  if (walk) {
    existence.walked.distance += walk->speed * std::min(dt, person.since_seen);
    existence.walked.distance = std::max(existence.walked.distance, walk->distance);
  }
  const auto leg = [&](int i) { return person.legs[i] ? &*person.legs[i] : nullptr; };
  weigh_surroundings(stood(leg(0), leg(1), options), existence);
  if (!both || existence.walked.distance >= Walked::kFree) return;
  const Sighting& a = person.legs[0]->last();
  const Sighting& b = person.legs[1]->last();
  const bool whole = !a.occluded && !b.occluded && std::min(a.width, b.width) >= kThinnest &&
                     std::abs(a.width - b.width) <= kAlike;
  Vector2 legs_apart = a.position - b.position;
  if ((legs_apart + person.foot_shifts.position()).norm() <
      (legs_apart - person.foot_shifts.position()).norm())
    legs_apart = -legs_apart;  // legs exchanged
  person.foot_shifts.add(a.time, legs_apart, whole, a.bearing, kOfPair);
  if (existence.appearance.log_odds() >= kLooksOfShifts)
    existence.foot_shifts =
        std::max({existence.foot_shifts, person.foot_shifts.log_odds(), shifts_of_legs(person, sweep)});
  double row = 0.0;
  if (stands(*person.legs[0]) && stands(*person.legs[1]))
    row = std::min(row_at(*person.legs[0], &*person.legs[1]), row_at(*person.legs[1], &*person.legs[0]));
  existence.row += gain * (row - existence.row);
}

void Weighing::weigh(std::vector<PersonTrack>& people, std::vector<ClusterTrack>& clusters,
                     std::int64_t sweep, double time, double dt, const Vector2& sensor,
                     const BirthOptions& options) {
  if ((sensor - stood_).norm() > kSensorStill) {
    stood_ = sensor;
    standing_since_ = time;
  }
  still_ = time - standing_since_ > kSensorStood;
  find_posts(people, clusters, sweep);
  const double gain = std::min(1.0, dt / kSlowly);
  double leglike = 0.0;
  for (ClusterTrack& cluster : clusters) {
    if (cluster.last().sweep != sweep) continue;
    weigh_cluster(cluster, gain);
    if (cluster.last().width <= kThin && cluster.existence.appearance.log_odds() > kLeastLooks)
      look_up(cluster, time);
    const bool came = cluster.past == Past::empty;
    cluster.existence.came = came ? Existence::kThingCame : 0.0;
    if (is_post(cluster, sweep) && !came && cluster.existence.appearance.log_odds() > 0.0) leglike += 1.0;
  }
  clutter_ += std::min(1.0, dt / (leglike > clutter_ ? kClutterGain : kClutterMemory)) * (leglike - clutter_);
  furniture_ +=
      std::min(1.0, dt / (leglike > furniture_ ? kClutterGain : kFurnitureMemory)) * (leglike - furniture_);
  count_company(people, dt);
  for (PersonTrack& person : people) {
    weigh_person(person, sweep, dt, gain, options);
    weigh_position(person, sweep, gain);
    weigh_coming(person, sweep, time);
    weigh_rigidity(person, sweep, dt);
    person.existence.keep_belief();
  }
}

}  // namespace bw::people
