// Parameters of the tracker. Defaults suit a laser at the height of shins with about 10 sweeps per
// second.
#pragma once

#include <string>

#include "components/people/tracker/external_detection_options.hpp"
#include "components/people/tracker/heading_filter.hpp"
#include "components/people/tracker/sweep_alignment.hpp"
#include "components/people/tracker/walker.hpp"
#include "runtime/base/field.hpp"

namespace bw::people {

struct AssociationOptions {
  /// a detection further than this from a track, in squared standard deviations (2 values), is not its own
  /// (set by code alone)
  double gate = 9.21;
  /// [m] nor is one further than this in metres: the radius of theory.md 7.2
  static constexpr double kReach = 1.2;
  /// [m] what was just seen is no further than this from where it is expected
  static constexpr double kStep = 0.3;
  /// [m/s] and by so much farther for each second since
  static constexpr double kPace = 2.0;
  /// [m] added to the spread of every prediction while detections are assigned, for people turn and stop
  static constexpr double kSlack = 0.12;
  /// weight of -ln(score) in the cost of giving a detection to a leg
  static constexpr double kUnlike = 2.0;
  /// what it adds to give a detection to something that is not a person
  static constexpr double kPeopleFirst = 2.0;
  /// cost of giving a detection that lies on background to a leg
  static constexpr double kOnStatic = 2.0;
  /// [m] detections wider than this are no part of a person
  static constexpr double kLargest = 0.8;
  /// [m] standard deviation added to a detection that does not look human, such as legs of two people in one
  /// (set by code alone)
  double vague = 0.1;
};

struct BirthOptions {
  double seen = 0.2;
  /// sightings of both legs that say whether they go straight: two always do
  static constexpr int kFewest = 3;
  /// [s] the last so many are no longer ago than this
  static constexpr double kWithin = 0.45;
  /// [m] way that the middle of the pair must have walked
  static constexpr double kTravel = 0.2;
  /// [m] widest distance from leg to leg while walking
  static constexpr double kSeparation = 0.6;
  /// [m] how far the middle of the pair may be from a straight way (root mean square)
  static constexpr double kMisfit = 0.08;
  /// least leg score of each leg of a pair that walks
  static constexpr double kWalkingScore = 0.4;
  /// [s] a pair that stands may be a person after this time
  static constexpr double kStandingTime = 0.3;
  /// [m] from leg to leg, at most, while standing
  static constexpr double kStandingSeparation = 0.42;
  /// least leg score of each leg of a pair that stands
  static constexpr double kStandingScore = 0.7;
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
  /// [m] longest step of a leg alone from sighting to sighting, beside 2 m/s; what leaps is something else
  static constexpr double kSingleStep = 0.15;
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
    v("seen", seen,
      {.unit = "s",
       .min = 0.05,
       .max = 1.0,
       .doc = "a pair that walks is a person once both legs have been seen for so long"});
    v.retired({"sightings"}, "birth.seen: a time, not a number of sweeps");
    v.retired({"misfit", "travel", "standing_score"}, "a constant of tracker_options.hpp");
  }
};

struct DeathOptions {
  double unseen = 1.0;
  double sigma = 0.9;
  /// share of a person's mean score that one sighting leaves as it was
  static constexpr double kScoreMemory = 0.9;
  /// somebody who stands with a lower mean score was furniture
  static constexpr double kUnlikeScore = 0.35;
  /// [m/s] slower counts as standing
  static constexpr double kUnlikeSpeed = 0.2;
  /// [s] clusters that are no person are forgotten when unseen for this long
  static constexpr double kClusterUnseen = 0.5;
  /// [m] a beam that ends by this much beyond a place shows that it is empty
  static constexpr double kMargin = 0.15;

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
       .doc =
           "a person whose position is less sure than this is gone, hidden or not; raise it to keep who is not seen "
           "longer"});
    v.retired({"unlike_score"}, "a constant of tracker_options.hpp");
  }
};

struct LegReassociationOptions {
  /// [m] people so close may have each other's legs
  static constexpr double kNear = 1.2;
  /// [m] widest distance from somebody to what may be a leg of theirs
  static constexpr double kSeparation = 0.7;
  /// least leg score of what may be a leg of theirs
  static constexpr double kScore = 0.4;
  /// how many of them are tried
  static constexpr int kUnrelatedClusters = 4;
  /// over how many of the last sightings legs are compared
  static constexpr int kSightings = 5;
  /// fewest of these sweeps that must show both legs
  static constexpr int kLeast = 3;
  /// [m] doubt of somebody of whom one leg is known
  static constexpr double kAlone = 0.8;
  /// [m] legs are paired anew when the new pairs are by this much less doubtful (set by code alone)
  double margin = 0.25;
  /// [m] legs less doubtful than this are one person's, and stay
  static constexpr double kSettled = 0.55;
};

struct HiddenOptions {
  /// score of a detection that shows somebody for sure
  static constexpr double kLikeness = 0.5;
  /// how many people let go are remembered at most, which bounds a sweep's cost
  static constexpr std::size_t kMaxLost = 20;
  /// [m/s] who was slower when seen last stood,
  static constexpr double kStoodSpeed = 0.15;
  /// [s] is remembered for so long,
  static constexpr double kStoodRemembered = 60.0;
  /// [m] and is whoever stands so near
  static constexpr double kSamePosition = 0.35;
  /// [s] somebody not seen for sure for this long is hidden, and may come back as somebody who appears
  static constexpr double kAbsent = 0.25;
  /// [s] who appears so long after somebody was lost may be them
  static constexpr double kRemembered = 20.0;
  /// guesses of where somebody hidden is
  static constexpr int kGuesses = 100;
  /// [m/s] standard deviation of a velocity when somebody is lost from sight, per axis
  static constexpr double kSpeedError = 0.2;
  /// [rad/s/sqrt(Hz)] how fast people out of sight change direction
  static constexpr double kWander = 0.5;
  /// [s] mean time until somebody out of sight goes elsewhere
  static constexpr double kKeepsCourse = 5.0;
  /// [s] somebody is overlooked for so long where the laser sees nothing (time constant)
  static constexpr double kOverlooked = 0.33;
  /// somebody hidden is no longer reported when they are less probably near where they are tracked
  static constexpr double kBelieved = 0.04;
  /// [m] a beam that ends by this much beyond a place shows that nobody hidden is there
  static constexpr double kMargin = 0.15;
  /// [m] how near to a guess somebody must appear to be the same (set by code alone)
  double position_kernel = 0.35;
  /// [m/s] and how near to its velocity they must go
  static constexpr double kVelocityKernel = 0.5;
  /// [s^2/m^4] density of people nobody has seen before: who appears where somebody lost is less likely is
  /// somebody new (set by code alone)
  double newcomers = 0.0005;
};

struct TrackerOptions {
  /// [m] radius that is reported of everybody
  static constexpr double kPersonRadius = 0.3;
  /// [s] a longer silence of the laser, or jump back in time, forgets everybody
  static constexpr double kLongestGap = 1.0;
  /// most detections of a sweep; of more the least human are ignored
  static constexpr int kMaxDetections = 1000;
  AlignmentOptions alignment;
  AssociationOptions association;
  WalkerOptions walker;
  HeadingOptions heading;
  BirthOptions birth;
  DeathOptions death;
  HiddenOptions hidden;
  ExternalDetectionOptions hearing;
  LegReassociationOptions leg_reassociation;

  template <class Visitor>
  void fields(Visitor& v) {
    v("birth", birth, {.doc = "when clusters become a person"});
    v("death", death, {.doc = "when a person is no longer believed to be there"});
    v.retired({"association", "walker", "untangle", "person_radius", "alignment", "motion", "heading",
               "hidden", "hearing"},
              "a constant of tracker_options.hpp");
  }
};

}  // namespace bw::people
