// Parameters of DWA and of what EDWA changes in it. Motion limits are the robot's (PlanningProblem::limits);
// Table 3.1 has 1 m/s, 0.35 rad/s and, by book 2.3, 1 m/s^2 and 1 rad/s^2.
#pragma once

#include <cstdint>

#include "components/local_planner/dwa/critic_options.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::dwa {

/// How samples are judged: by DWB's critics, or as published, where columns of scores are made comparable (D8) by:
enum class Profile {
  critics,  ///< plan, footprint and turns on the spot (book 5.9)
  fixed_scales,
  sum,              ///< each by its sum
  minmax,           ///< each by its range (Fox, Burgard, Thrun 1997)
  teaching_sample,  ///< the MATLAB sample that Table 3.1's constants come from: by sums, gap of the end pose
};
constexpr auto choice_table(Profile) {
  return choices<Profile>({{Profile::critics, "critics"},
                           {Profile::fixed_scales, "scales"},
                           {Profile::sum, "sum"},
                           {Profile::minmax, "minmax"},
                           {Profile::teaching_sample, "sample"}});
}

/// Where EDWA's heading term comes from.
enum class EdwaHeading {
  hrvo,          ///< towards the direction that HRVO advises (D5)
  hrvo_printed,  ///< (3.4) as printed, which turns away from it
  goal,          ///< as DWA
};
constexpr auto choice_table(EdwaHeading) {
  return choices<EdwaHeading>({{EdwaHeading::hrvo, "hrvo"},
                               {EdwaHeading::hrvo_printed, "hrvo_printed"},
                               {EdwaHeading::goal, "goal"}});
}

struct DwaOptions {
  Profile profile = Profile::critics;
  CriticOptions critics;
  double heading_weight = 3.0;
  double clearance_weight = 0.1;
  double velocity_weight = 0.1;
  double sim_time = 3.0;
  double sim_granularity = 0.1;
  std::int64_t v_samples = 11;
  std::int64_t omega_samples = 21;
  double contact_margin = 0.1;
  double clearance_cap = 3.0;
  double carrot_distance = 4.0;
  bool arc_to_goal = true;
  bool check_movers = true;
  bool limit_turn_rate = false;
  bool hold_before_braking = true;
  bool predict_movers = false;
  bool leave_margin = true;
  std::int64_t shown_candidates = 10;

  template <class Visitor>
  void fields(Visitor& v) {
    v("profile", profile,
      {.doc =
           "how samples are judged: critics, by plan and footprint, as DWB's users know it; else (3.1), its "
           "terms made comparable by fixed scales, by each column's sum, by its range (minmax); sample: "
           "the MATLAB teaching sample"});
    v("critics", critics, {.doc = "profile critics"});
    v("heading_weight", heading_weight,
      {.min = 0,
       .max = 1000,
       .doc = "alpha of (3.1): turning towards the aim; raise it to keep to the plan"});
    v("clearance_weight", clearance_weight,
      {.min = 0,
       .max = 1000,
       .doc = "beta of (3.1): the smallest gap of the roll-out; raise it to pass obstacles more widely"});
    v("velocity_weight", velocity_weight,
      {.min = 0, .max = 1000, .doc = "gamma of (3.1): speed; raise it for a robot that dawdles"});
    v("sim_time", sim_time,
      {.unit = "s", .min = 0.1, .max = 20, .doc = "length of a roll-out, cut where the goal is reached"});
    v("sim_granularity", sim_granularity,
      {.unit = "s",
       .min = 0.01,
       .max = 1,
       .doc = "time between two looks at the gap along a roll-out; coarser is faster"});
    v("v_samples", v_samples,
      {.min = 2,
       .max = 201,
       .doc = "how many speeds are tried in the dynamic window; the time of a cycle grows with it"});
    v("omega_samples", omega_samples,
      {.min = 2,
       .max = 201,
       .doc = "how many turn rates are tried for each speed; the time of a cycle grows with it"});
    v("contact_margin", contact_margin,
      {.unit = "m",
       .min = 0,
       .max = 5,
       .doc = "a gap this small counts as contact when braking is judged; raise it to keep further away"});
    v("clearance_cap", clearance_cap,
      {.unit = "m",
       .min = 0.01,
       .max = 100,
       .doc = "gaps larger than this count as equal (profile sample: 2 m)"});
    v("carrot_distance", carrot_distance,
      {.unit = "m",
       .min = 0,
       .max = 100,
       .doc = "the robot aims at the plan this far ahead; shorter cuts corners less; 0: at its end, as "
              "published"});
    v("arc_to_goal", arc_to_goal,
      {.doc = "slow enough to reach a final goal on one arc; false: as published, may circle it"});
    v("check_movers", check_movers,
      {.doc = "a velocity is taken only if braking one control period later stays clear of where movers will "
              "be; false: as published"});
    v("limit_turn_rate", limit_turn_rate,
      {.doc = "admissible also means that turning can end before the contact (Fox 1997)"});
    v("hold_before_braking", hold_before_braking,
      {.doc =
           "admissible is what stops in time when braking begins one control period later; false: at once, "
           "as published"});
    v("predict_movers", predict_movers,
      {.doc = "clearance to movers where they will be; false: where they are now, as published"});
    v("leave_margin", leave_margin,
      {.doc = "inside the contact margin, arcs that come no closer are admissible; false: none is"});
    v("shown_candidates", shown_candidates,
      {.min = 1, .max = 1000, .doc = "how many arcs are handed out for display, the best first"});
  }
};

struct EdwaOptions {
  EdwaHeading heading = EdwaHeading::hrvo;
  double heading_time = 1.0;
  bool hrvo_speed = true;
  double mover_horizon = 3.0;
  double heading_scale = 60.0;
  double advised_speed_scale = 30.0;
  double passing_scale = 200.0;
  double passing_gap = 0.8;
  double passing_power = 2.0;
  double passing_fading = 0.7;

  template <class Visitor>
  void fields(Visitor& v) {
    v("heading", heading,
      {.doc = "turn towards the HRVO direction; hrvo_printed: (3.4) as printed, turns away; goal: as DWA"});
    v("heading_time", heading_time,
      {.unit = "s",
       .min = 0.05,
       .max = 10,
       .doc = "the heading that a sample has after this time is compared with the HRVO direction"});
    v("hrvo_speed", hrvo_speed, {.doc = "the best speed is that of HRVO; false: the highest"});
    v("mover_horizon", mover_horizon,
      {.unit = "s",
       .min = 0,
       .max = 20,
       .doc =
           "profile critics: HRVO leads while the robot could meet somebody within this time, else the plan "
           "does"});
    v("heading_scale", heading_scale,
      {.unit = "1/rad",
       .min = 0,
       .max = 1000,
       .doc =
           "profile critics: cost of heading elsewhere than HRVO advises; raise it to leave the plan sooner"});
    v("advised_speed_scale", advised_speed_scale,
      {.unit = "s/m", .min = 0, .max = 1000, .doc = "profile critics: cost of another speed than HRVO's"});
    v("passing_scale", passing_scale,
      {.min = 0,
       .max = 10000,
       .doc =
           "profile critics: cost of a velocity by which somebody who walks is touched within mover_horizon, "
           "and of part of it where they are passed within passing_gap; lower it for a faster drive in crowds; 0: people are HRVO's alone"});
    v("passing_gap", passing_gap,
      {.unit = "m",
       .min = 0.01,
       .max = 5,
       .doc = "profile critics: people who walk are passed this widely at no cost"});
    v("passing_power", passing_power,
      {.min = 0.1,
       .max = 10,
       .doc =
           "profile critics: of people slower than the robot can be, that cost grows with this power of what is missing of "
           "passing_gap; higher spares detours for who is passed widely enough"});
    v("passing_fading", passing_fading,
      {.min = 0,
       .max = 1,
       .doc =
           "profile critics: of people slower than the robot can be, by this share that cost is less when they are passed at the "
           "end of mover_horizon than now: there is time for them"});
  }
};

}  // namespace bw::dwa
