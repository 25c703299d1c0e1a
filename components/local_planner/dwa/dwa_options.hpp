// Parameters of DWA and of what EDWA changes in it. Motion limits are the robot's (PlanningProblem::limits);
// Table 3.1 has 1 m/s, 0.35 rad/s and, by model/README.md 2.3, 1 m/s^2 and 1 rad/s^2.
#pragma once

#include <cstddef>

#include "components/local_planner/dwa/critic_options.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::dwa {

/// How samples are judged.
enum class Profile {
  critics,  ///< as DWB does it: plan, footprint and turns on the spot (theory.md 5.9)
  scales,   ///< (3.1) as published
};
constexpr auto choice_table(Profile) {
  return choices<Profile>({{Profile::critics, "critics"}, {Profile::scales, "scales"}});
}

/// How a column of scores is made comparable with the others (D8).
enum class Normalisation {
  scale,   ///< divided by a fixed scale
  sum,     ///< divided by the column's sum
  minmax,  ///< its range mapped to [0, 1] (Fox, Burgard, Thrun 1997)
};

/// Where EDWA's heading term comes from.
enum class EdwaHeading {
  hrvo,          ///< towards the direction that HRVO advises (D5)
  hrvo_printed,  ///< (3.4) as printed, which turns away from it
  goal,          ///< as DWA
};

/// Of (3.1), Table 3.1.
struct ScoreWeights {
  double heading = 3.0;
  double clearance = 0.1;
  double velocity = 0.1;
};

/// A gap this small [m] counts as contact when braking is judged as published.
inline constexpr double kContactMargin = 0.1;

struct DwaOptions {
  Profile profile = Profile::critics;
  CriticOptions critics;
  bool check_movers = true;
  /// clearance to movers where they will be; else where they are now, as published (set by code alone)
  bool predict_movers = false;

  // What tells the published forms apart is set by code, where their tables are made; the defaults are what
  // drives best.
  ScoreWeights weights;
  Normalisation normalisation = Normalisation::scale;
  bool teaching_sample =
      false;              ///< the MATLAB sample that Table 3.1's constants come from: gap of the end pose
  double sim_time = 3.0;  ///< length of a roll-out [s], cut where the goal is reached
  int v_samples = 11;
  int omega_samples = 21;           ///< for each speed
  double carrot_distance = 4.0;     ///< it aims at the plan this far ahead [m]; 0: at its end, as published
  bool arc_to_goal = true;          ///< slow enough to reach a final goal on one arc; else it may circle it
  bool limit_turn_rate = false;     ///< turning, too, can end before the contact (Fox 1997)
  bool hold_before_braking = true;  ///< braking begins one control period later; else at once
  bool leave_margin = true;         ///< inside kContactMargin, arcs that come no closer are admissible
  std::size_t shown_candidates = 10;

  template <class Visitor>
  void fields(Visitor& v) {
    v("profile", profile,
      {.doc =
           "how samples are judged: critics, by plan and footprint, as DWB's users know it; scales, by (3.1)"});
    v("critics", critics, {.doc = "profile critics"});
    v("check_movers", check_movers,
      {.doc = "a velocity is taken only if braking one control period later stays clear of where movers will "
              "be; false: as published"});
    v.retired({"predict_movers"}, "set by code alone, in dwa_options.hpp");
  }
};

struct EdwaOptions {
  double passing_gap = 0.8;

  // Set by code, as above.
  double mover_horizon = 3.0;    ///< HRVO leads while the robot could meet somebody within this time [s]
  double heading_scale = 60.0;   ///< cost of heading elsewhere than HRVO advises [1/rad]
  double passing_scale = 200.0;  ///< cost of touching somebody who walks within mover_horizon, and of part of
                                 ///< it where they are passed within passing_gap; 0: people are HRVO's alone
  EdwaHeading heading = EdwaHeading::hrvo;  ///< of the published form
  bool hrvo_speed = true;                   ///< the best speed is that of HRVO (D6); else the highest
  double advised_speed_scale = 30.0;        ///< cost of another speed than HRVO's [s/m]
  double passing_power =
      2.0;  ///< of slow people, the cost grows with this power of what is missing of passing_gap
  double passing_fading =
      0.7;  ///< and is less by this share at the end of mover_horizon: there is time for them

  template <class Visitor>
  void fields(Visitor& v) {
    v("passing_gap", passing_gap,
      {.unit = "m",
       .min = 0.01,
       .max = 5,
       .doc = "people who walk are passed this widely at no cost; raise it for wider berths"});
    v.retired({"mover_horizon", "heading_scale", "passing_scale"}, "set by code alone, in dwa_options.hpp");
  }
};

/// [s] after which the heading of a sample is compared with the direction that HRVO advises (theory.md 5.4).
inline constexpr double kHeadingTime = 1.0;

}  // namespace bw::dwa
