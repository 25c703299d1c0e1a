// Parameters of the tracker. Defaults suit a laser at the height of shins with about 10 sweeps per
// second.
#pragma once

#include <string>

#include "components/people/tracker/heading_filter.hpp"
#include "components/people/tracker/hearing_options.hpp"
#include "components/people/tracker/sweep_alignment.hpp"
#include "components/people/tracker/walker.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::people {

struct AssociationOptions {
  double gate = 9.21;
  double reach = 1.2;
  double step = 0.5;
  double pace = 0.2;
  double slack = 0.12;
  double unlike = 2.0;
  /// what it adds to give a detection to something that is not a person
  static constexpr double kPeopleFirst = 2.0;
  double on_static = 2.0;
  double largest = 0.8;
  double vague = 0.1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("gate", gate,
      {.min = 1,
       .max = 100,
       .doc = "a detection further than this from a track, in squared standard deviations (2 values), is "
              "not its own"});
    v("reach", reach,
      {.unit = "m",
       .min = 0.1,
       .max = 5,
       .doc = "nor is one further than this in metres: the radius of book 7.2"});
    v("step", step,
      {.unit = "m", .min = 0.05, .max = 5, .doc = "longest step of a leg that was seen in the last sweep"});
    v("pace", pace,
      {.unit = "m", .min = 0, .max = 5, .doc = "by this much longer for each sweep that missed the leg"});
    v("slack", slack,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc = "added to the spread of every prediction while detections are assigned, for people turn and "
              "stop"});
    v("unlike", unlike,
      {.min = 0,
       .max = 20,
       .doc = "weight of -ln(score) in the cost of giving a detection to a leg; raise it to trust scores "
              "more"});
    v("on_static", on_static,
      {.min = 0, .max = 20, .doc = "cost of giving a detection that lies on background to a leg"});
    v("vague", vague,
      {.unit = "m",
       .min = 0,
       .max = 2,
       .doc = "standard deviation added to a detection that does not look human, such as legs of two "
              "people in one"});
    v("largest", largest,
      {.unit = "m", .min = 0.2, .max = 10, .doc = "detections wider than this are no part of a person"});
  }
};

struct BirthOptions {
  int sightings = 3;
  double within = 0.45;
  double travel = 0.2;
  double separation = 0.6;
  double misfit = 0.08;
  double walking_score = 0.4;
  double standing_time = 0.3;
  /// [m] from leg to leg, at most, while standing
  static constexpr double kStandingSeparation = 0.42;
  double standing_score = 0.7;
  /// score of a leg that stands behind the edge of something, half of the time or more; the other one has standing_score.
  /// Such a pair is one where people walk about and little else looks like a leg,
  static constexpr double kHalfHiddenScore = 0.4;
  /// and is seen for so long [s]
  static constexpr double kHalfHiddenTime = 0.9;
  /// score of each leg of a pair that stands where something has long stood
  static constexpr double kBackgroundScore = 0.8;
  /// [s] for which each leg of such a pair is seen
  static constexpr double kBackgroundTime = 0.7;
  /// [s] what was seen earlier says nothing of how somebody walks
  static constexpr double kLookBack = 1.15;
  /// [m] way walked by a leg, or two legs in one, alone
  static constexpr double kSingleTravel = 0.5;
  /// [s] for which it does
  static constexpr double kSingleTime = 0.45;
  /// share of sweeps that show it meanwhile
  static constexpr double kSingleSeen = 0.7;
  /// share of sightings on background
  static constexpr double kSingleStatic = 0.3;
  double single_step = 0.15;
  /// [m/s] beside single_step
  static constexpr double kSingleSpeed = 2.0;
  /// mean human score of such a leg
  static constexpr double kSingleScore = 0.6;
  /// share of its path that brought it forward
  static constexpr double kSingleStraight = 0.8;
  /// share of sightings in which something may hide an edge of it
  static constexpr double kSingleCut = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("sightings", sightings,
      {.min = 2, .max = 12, .doc = "a pair that walks is a person after this many sightings of both legs"});
    v("within", within,
      {.unit = "s", .min = 0.1, .max = 2, .doc = "the last so many sightings are no longer ago than this"});
    v("travel", travel,
      {.unit = "m",
       .min = 0.05,
       .max = 3,
       .doc = "way that the middle of the pair must have walked; raise it against false people"});
    v("separation", separation,
      {.unit = "m", .min = 0.2, .max = 1, .doc = "widest distance from leg to leg while walking"});
    v("misfit", misfit,
      {.unit = "m",
       .min = 0.01,
       .max = 1,
       .doc = "how far the middle of the pair may be from a straight way (root mean square)"});
    v("walking_score", walking_score,
      {.min = 0, .max = 1, .doc = "least leg score of each leg of a pair that walks"});
    v("standing_time", standing_time,
      {.unit = "s", .min = 0, .max = 0.8, .doc = "a pair that stands may be a person after this time"});
    v("standing_score", standing_score,
      {.min = 0,
       .max = 1,
       .doc = "least leg score of each leg of a pair that stands; raise it against chairs"});
    v("single_step", single_step,
      {.unit = "m",
       .min = 0.05,
       .max = 2,
       .doc = "longest step of a leg alone from sighting to sighting, beside 2 m/s; what leaps is something "
              "else"});
  }
};

struct DeathOptions {
  double unseen = 1.0;
  double sigma = 0.9;
  /// share of a person's mean score that one sighting leaves as it was
  static constexpr double kScoreMemory = 0.9;
  double unlike_score = 0.35;
  /// [m/s] slower counts as standing
  static constexpr double kUnlikeSpeed = 0.2;
  double cluster_unseen = 0.5;
  double margin = 0.15;

  template <class Visitor>
  void fields(Visitor& v) {
    v("unseen", unseen,
      {.unit = "s",
       .min = 0.1,
       .max = 10,
       .doc = "a person not seen for this long where beams pass is gone"});
    v("sigma", sigma,
      {.unit = "m",
       .min = 0.1,
       .max = 5,
       .doc = "a person whose position is less sure than this is gone, hidden or not"});
    v("unlike_score", unlike_score,
      {.min = 0, .max = 1, .doc = "somebody who stands with a lower mean score was furniture"});
    v("cluster_unseen", cluster_unseen,
      {.unit = "s",
       .min = 0.1,
       .max = 10,
       .doc = "clusters that are no person are forgotten when unseen for this long"});
    v("margin", margin,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc = "a beam that ends by this much beyond a place shows that it is empty"});
  }
};

struct UntangleOptions {
  double near = 1.2;
  double separation = 0.7;
  double score = 0.4;
  /// how many of them are tried
  static constexpr int kStrangers = 4;
  int sightings = 5;
  int least = 3;
  double alone = 0.8;
  double margin = 0.25;
  double settled = 0.55;

  template <class Visitor>
  void fields(Visitor& v) {
    v("near", near, {.unit = "m", .min = 0, .max = 5, .doc = "people so close may have each other's legs"});
    v("separation", separation,
      {.unit = "m",
       .min = 0,
       .max = 2,
       .doc = "widest distance from somebody to what may be a leg of theirs"});
    v("score", score, {.min = 0, .max = 1, .doc = "least leg score of what may be a leg of theirs"});
    v("sightings", sightings,
      {.min = 2, .max = 12, .doc = "over how many of the last sightings legs are compared"});
    v("least", least, {.min = 2, .max = 12, .doc = "fewest of these sweeps that must show both legs"});
    v("alone", alone, {.unit = "m", .min = 0, .max = 5, .doc = "doubt of somebody of whom one leg is known"});
    v("margin", margin,
      {.unit = "m",
       .min = 0,
       .max = 5,
       .doc = "legs are paired anew when the new pairs are by this much less doubtful"});
    v("settled", settled,
      {.unit = "m", .min = 0, .max = 5, .doc = "legs less doubtful than this are one person's, and stay"});
  }
};

struct HiddenOptions {
  /// score of a detection that shows somebody for sure
  static constexpr double kLikeness = 0.5;
  /// how many people let go are remembered at most, which bounds a sweep's cost
  static constexpr std::size_t kMostLost = 20;
  /// [m/s] who was slower when seen last stood,
  static constexpr double kStoodSpeed = 0.15;
  /// [s] is remembered for so long,
  static constexpr double kStoodRemembered = 60.0;
  /// [m] and is whoever stands so near
  static constexpr double kSamePlace = 0.35;
  double absent = 0.25;
  double remembered = 20.0;
  int guesses = 100;
  double speed_error = 0.2;
  double wander = 0.5;
  double keeps_way = 5.0;
  double overlooked = 0.33;
  double believed = 0.04;
  double margin = 0.15;
  double place_kernel = 0.35;
  double velocity_kernel = 0.5;
  double newcomers = 0.0005;

  template <class Visitor>
  void fields(Visitor& v) {
    v("absent", absent,
      {.unit = "s",
       .min = 0,
       .max = 60,
       .doc =
           "somebody not seen for sure for this long is hidden, and may come back as somebody who appears"});
    v("remembered", remembered,
      {.unit = "s", .min = 0, .max = 60, .doc = "who appears so long after somebody was lost may be them"});
    v("guesses", guesses,
      {.min = 20, .max = 2000, .doc = "guesses of where somebody hidden is; raise it for larger places"});
    v("speed_error", speed_error,
      {.unit = "m/s",
       .min = 0,
       .max = 5,
       .doc = "standard deviation of a velocity when somebody is lost from sight, per axis"});
    v("wander", wander,
      {.unit = "rad/s/sqrt(Hz)",
       .min = 0,
       .max = 10,
       .doc = "how fast people out of sight change direction"});
    v("keeps_way", keeps_way,
      {.unit = "s", .min = 0.1, .max = 1000, .doc = "mean time until somebody out of sight goes elsewhere"});
    v("overlooked", overlooked,
      {.unit = "s",
       .min = 0.01,
       .max = 100,
       .doc = "somebody is overlooked for so long where the laser sees nothing (time constant)"});
    v("believed", believed,
      {.min = 0,
       .max = 1,
       .doc =
           "somebody hidden is no longer reported when they are less probably near where they are tracked"});
    v("margin", margin,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc = "a beam that ends by this much beyond a place shows that nobody hidden is there"});
    v("place_kernel", place_kernel,
      {.unit = "m", .min = 0.05, .max = 5, .doc = "how near to a guess somebody must appear to be the same"});
    v("velocity_kernel", velocity_kernel,
      {.unit = "m/s", .min = 0.05, .max = 5, .doc = "and how near to its velocity they must go"});
    v("newcomers", newcomers,
      {.unit = "s^2/m^4",
       .min = 0,
       .max = 10,
       .doc = "density of people nobody has seen before: who appears where somebody lost is less likely is "
              "somebody new; raise it where many come and go"});
  }
};

/// Which filter of a person's motion is reported.
enum class MotionFilter { gait, heading };
constexpr auto choice_table(MotionFilter) {
  return choices<MotionFilter>({{MotionFilter::gait, "gait"}, {MotionFilter::heading, "heading"}});
}

struct TrackerOptions {
  double person_radius = 0.3;
  double longest_gap = 1.0;
  int most_detections = 1000;
  AlignmentOptions alignment;
  AssociationOptions association;
  MotionFilter motion = MotionFilter::heading;
  WalkerOptions walker;
  HeadingOptions heading;
  BirthOptions birth;
  DeathOptions death;
  HiddenOptions hidden;
  HearingOptions hearing;
  UntangleOptions untangle;

  template <class Visitor>
  void fields(Visitor& v) {
    v("person_radius", person_radius,
      {.unit = "m", .min = 0.05, .max = 1, .doc = "radius that is reported of everybody"});
    v("longest_gap", longest_gap,
      {.unit = "s",
       .min = 0.1,
       .max = 60,
       .doc = "a longer silence of the laser, or jump back in time, forgets everybody"});
    v("most_detections", most_detections,
      {.min = 1, .max = 20000, .doc = "most detections of a sweep; of more the least human are ignored"});
    v("alignment", alignment, {.doc = "taking out errors of odometry from sweep to sweep"});
    v("association", association, {.doc = "which detection belongs to whom"});
    v("motion", motion,
      {.doc =
           "which filter's position, velocity and covariance are reported; legs are always assigned by the "
           "gait. gait: both legs swing (walker); heading: position, heading and speed of the point between "
           "the legs (heading)"});
    v("walker", walker, {.doc = "how people and their legs move"});
    v("heading", heading, {.doc = "the filter that motion: heading reports"});
    v("birth", birth, {.doc = "when clusters become a person"});
    v("death", death, {.doc = "when a person is no longer believed to be there"});
    v("untangle", untangle, {.doc = "whose leg is whose where people pass close to each other"});
    v("hidden", hidden, {.doc = "where people may be who are not seen, and who of them appears again"});
    v("hearing", hearing, {.doc = "people whom other detectors tell of"});
  }
};

}  // namespace bw::people
