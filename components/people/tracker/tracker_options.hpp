// Parameters of the tracker. Defaults suit a laser at the height of shins with about 10 sweeps per
// second.
#pragma once

#include <string>

#include "components/people/tracker/heading_filter.hpp"
#include "components/people/tracker/sweep_alignment.hpp"
#include "components/people/tracker/walker.hpp"
#include "runtime/base/field.hpp"

namespace bw::people {

struct AssociationOptions {
  double gate = 9.21;
  double reach = 1.2;
  double step = 0.5;
  double pace = 0.2;
  double slack = 0.12;
  double unlike = 2.0;
  double people_first = 2.0;
  double on_static = 2.0;
  double largest = 0.8;
  double vague = 0.1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("gate", gate,
      {.min = 1, .max = 100, .doc = "squared standard deviations (2 dof) that may lie between"});
    v("reach", reach,
      {.unit = "m", .min = 0.1, .max = 5, .doc = "and metres: the human-oriented gate of book 7.2"});
    v("step", step, {.unit = "m", .min = 0.05, .max = 5, .doc = "of a leg that was just seen, at most"});
    v("pace", pace,
      {.unit = "m", .min = 0, .max = 5, .doc = "and so much more for each sweep that missed it"});
    v("slack", slack,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc = "added to the spread of every prediction while choosing: people turn and stop"});
    v("unlike", unlike,
      {.min = 0, .max = 20, .doc = "what -ln(score) of a detection adds for legs of people"});
    v("on_static", on_static,
      {.min = 0, .max = 20, .doc = "what it adds that a detection lies on background, for legs of people"});
    v("people_first", people_first,
      {.min = 0, .max = 20, .doc = "what it adds to give a detection to something that is not a person"});
    v("vague", vague,
      {.unit = "m",
       .min = 0,
       .max = 2,
       .doc = "error added to a detection that does not look human: two legs of two people, half a leg"});
    v("largest", largest,
      {.unit = "m", .min = 0.2, .max = 10, .doc = "wider detections are no part of a person"});
  }
};

struct BirthOptions {
  int sightings = 3;
  int of_sweeps = 5;
  double travel = 0.2;
  double separation = 0.6;
  double misfit = 0.05;
  double walking_score = 0.4;
  int standing_sightings = 4;
  double standing_separation = 0.42;
  double standing_score = 0.7;
  double background_score = 0.8;
  int background_sightings = 8;
  double single_travel = 0.5;
  int single_sightings = 6;
  int single_of_sweeps = 8;
  double single_step = 0.35;
  double single_score = 0.6;
  double single_straight = 0.8;
  double single_cut = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("sightings", sightings, {.min = 2, .max = 12, .doc = "of both legs"});
    v("of_sweeps", of_sweeps, {.min = 2, .max = 12, .doc = "within so many sweeps"});
    v("travel", travel, {.unit = "m", .min = 0.05, .max = 3, .doc = "way walked by the middle of two legs"});
    v("separation", separation,
      {.unit = "m", .min = 0.2, .max = 1, .doc = "from leg to leg, at most, while walking"});
    v("misfit", misfit,
      {.unit = "m", .min = 0.01, .max = 1, .doc = "of the middle to a straight way, root mean square"});
    v("walking_score", walking_score, {.min = 0, .max = 1, .doc = "of each leg of a pair that walks"});
    v("standing_sightings", standing_sightings, {.min = 2, .max = 12, .doc = "of a pair that stands"});
    v("standing_separation", standing_separation,
      {.unit = "m", .min = 0.1, .max = 1, .doc = "from leg to leg, at most, while standing"});
    v("standing_score", standing_score, {.min = 0, .max = 1, .doc = "of each leg of a pair that stands"});
    v("background_score", background_score,
      {.min = 0, .max = 1, .doc = "of each leg of a pair that stands where something has long stood"});
    v("background_sightings", background_sightings, {.min = 2, .max = 12, .doc = "of such a pair"});
    v("single_travel", single_travel,
      {.unit = "m", .min = 0.05, .max = 3, .doc = "way walked by a leg, or two legs in one, alone"});
    v("single_sightings", single_sightings, {.min = 2, .max = 12, .doc = "of it"});
    v("single_of_sweeps", single_of_sweeps, {.min = 2, .max = 40, .doc = "within so many sweeps"});
    v("single_step", single_step,
      {.unit = "m",
       .min = 0.05,
       .max = 2,
       .doc = "from sighting to sighting, at most: else it is something else"});
    v("single_score", single_score, {.min = 0, .max = 1, .doc = "of it"});
    v("single_cut", single_cut,
      {.min = 0, .max = 1, .doc = "share of sightings in which something may hide an edge of it"});
    v("single_straight", single_straight,
      {.min = 0, .max = 1, .doc = "share of its path that brought it forward"});
  }
};

struct DeathOptions {
  double unseen = 1.0;
  double sigma = 0.9;
  double score_memory = 0.9;
  double unlike_score = 0.35;
  double unlike_speed = 0.2;
  double cluster_unseen = 0.5;
  double margin = 0.15;

  template <class Visitor>
  void fields(Visitor& v) {
    v("unseen", unseen,
      {.unit = "s", .min = 0.1, .max = 10, .doc = "not seen so long where they could have been"});
    v("sigma", sigma, {.unit = "m", .min = 0.1, .max = 5, .doc = "position not known better, hidden or not"});
    v("score_memory", score_memory,
      {.min = 0, .max = 0.999, .doc = "share of a person's mean score that one sighting leaves as it was"});
    v("unlike_score", unlike_score,
      {.min = 0, .max = 1, .doc = "mean score of somebody who stands, below which it was furniture"});
    v("unlike_speed", unlike_speed, {.unit = "m/s", .min = 0, .max = 5, .doc = "slower counts as standing"});
    v("cluster_unseen", cluster_unseen,
      {.unit = "s", .min = 0.1, .max = 10, .doc = "other clusters are forgotten then"});
    v("margin", margin,
      {.unit = "m", .min = 0, .max = 1, .doc = "a beam that passes by so much beyond shows an empty place"});
  }
};

struct UntangleOptions {
  double near = 1.2;
  double separation = 0.7;
  double score = 0.4;
  int strangers = 4;
  int sightings = 5;
  int least = 3;
  double alone = 0.8;
  double margin = 0.25;
  double settled = 0.55;

  template <class Visitor>
  void fields(Visitor& v) {
    v("near", near, {.unit = "m", .min = 0, .max = 5, .doc = "people so close may have each other's legs"});
    v("separation", separation,
      {.unit = "m", .min = 0, .max = 2, .doc = "from somebody to what may be a leg of theirs, at most"});
    v("score", score, {.min = 0, .max = 1, .doc = "leg score of it, at least"});
    v("strangers", strangers, {.min = 0, .max = 20, .doc = "how many of them are tried"});
    v("sightings", sightings, {.min = 2, .max = 12, .doc = "how far back legs are compared"});
    v("least", least, {.min = 2, .max = 12, .doc = "sweeps that must show both legs"});
    v("alone", alone, {.unit = "m", .min = 0, .max = 5, .doc = "doubt of somebody of whom one leg is known"});
    v("margin", margin,
      {.unit = "m", .min = 0, .max = 5, .doc = "pairs must be so much less doubtful to be changed"});
    v("settled", settled, {.unit = "m", .min = 0, .max = 5, .doc = "legs less doubtful are one person's"});
  }
};

struct ReturnOptions {
  double likeness = 0.5;
  double absent = 0.25;
  double remembered = 6.0;
  double slack = 0.5;
  double speed = 1.5;
  double deviation = 0.4;

  template <class Visitor>
  void fields(Visitor& v) {
    v("likeness", likeness, {.min = 0, .max = 1, .doc = "score of a detection that shows somebody for sure"});
    v("absent", absent, {.unit = "s", .min = 0, .max = 60, .doc = "not seen for sure so long is lost"});
    v("remembered", remembered,
      {.unit = "s", .min = 0, .max = 60, .doc = "who appears so long after somebody was lost may be them"});
    v("slack", slack, {.unit = "m", .min = 0, .max = 2, .doc = "from where they could be, at once"});
    v("speed", speed, {.unit = "m/s", .min = 0, .max = 5, .doc = "nobody goes faster out of sight"});
    v("deviation", deviation,
      {.unit = "m/s", .min = 0, .max = 5, .doc = "how fast people leave their straight way out of sight"});
  }
};

struct TrackerOptions {
  double person_radius = 0.3;
  double longest_gap = 1.0;
  int most_detections = 1000;
  AlignmentOptions alignment;
  AssociationOptions association;
  std::string motion = "heading";
  WalkerOptions walker;
  HeadingOptions heading;
  BirthOptions birth;
  DeathOptions death;
  ReturnOptions back;
  UntangleOptions untangle;

  template <class Visitor>
  void fields(Visitor& v) {
    v("person_radius", person_radius, {.unit = "m", .min = 0.05, .max = 1, .doc = "reported of everybody"});
    v("longest_gap", longest_gap,
      {.unit = "s", .min = 0.1, .max = 60, .doc = "silence or jump back in time that forgets everybody"});
    v("most_detections", most_detections,
      {.min = 1, .max = 20000, .doc = "of a sweep; the rest is ignored, the least human first"});
    v("alignment", alignment, {.doc = "errors of odometry from sweep to sweep"});
    v("association", association, {.doc = "which detection belongs to whom"});
    v("motion", motion,
      {.choices = {"gait", "heading"},
       .doc =
           "which filter's position, velocity and covariance are reported; legs are always assigned by the "
           "gait. gait: both legs swing (walker); heading: position, heading and speed of the point between "
           "the legs (heading)"});
    v("walker", walker, {.doc = "how people and their legs move"});
    v("heading", heading, {.doc = "the filter of motion: heading"});
    v("birth", birth, {.doc = "when clusters become a person"});
    v("death", death, {.doc = "when a person is no longer believed to be there"});
    v("untangle", untangle, {.doc = "whose leg is whose where people pass close to each other"});
    v("return", back, {.doc = "when somebody who appears is somebody lost"});
  }
};

}  // namespace bw::people
