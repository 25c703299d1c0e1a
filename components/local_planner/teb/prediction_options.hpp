// How the band sees movers: where they are expected, and how sure that is (theory.md 6.5, D10).
#pragma once

#include <algorithm>

#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::teb {

/// Where a mover is when a pose of the band meets it.
enum class Prediction {
  time_indexed,  ///< where it will be at the pose's time
  doubled,       ///< at its present and at one future place, standing (6.5 as published)
  present,       ///< at its present place, standing
};
constexpr auto choice_table(Prediction) {
  return choices<Prediction>({{Prediction::time_indexed, "time_indexed"},
                              {Prediction::doubled, "doubled"},
                              {Prediction::present, "present"}});
}

struct PredictionOptions {
  Prediction prediction = Prediction::time_indexed;
  double uncertainty_factor = 0.0;
  /// share of that growth that counts when bands are compared. 0: it bends each band, and people count in the
  /// choice where they are expected; 1: a band that waits or goes round wins more often (set by code alone)
  double uncertainty_in_choice = 0.0;
  double assumed_pedestrian_speed = 0.0;
  /// [s] for so long people who turn round beside a slow robot come nearer, before it is out of their way
  static constexpr double kAssumedPedestrianTime = 1.5;

  // By code: what each planner begins from.
  double prediction_time = 1.6;     ///< how far ahead the second place lies [s] (doubled): 4 steps of 0.4 s
  double uncertainty_growth = 0.0;  ///< of the standard deviation where predictions have none [m/s]
  double max_uncertainty = 0.3;     ///< the inflation of a mover grows at most by this [m]

  template <class Visitor>
  void fields(Visitor& v) {
    v("prediction", prediction,
      {.doc =
           "time_indexed: every pose meets a mover where it is at the pose's time; doubled: movers are discs "
           "that stand at their present and at their future place; present: at their present place only"});
    v("uncertainty_factor", uncertainty_factor,
      {.min = 0,
       .max = 5,
       .doc = "how many standard deviations of its prediction the inflation of a mover grows by; raise it "
              "among people who turn"});
    v("assumed_pedestrian_speed", assumed_pedestrian_speed,
      {.unit = "m/s",
       .min = 0,
       .max = 3,
       .doc =
           "of people who turn towards the robot. One whose top speed is less keeps further from movers, by "
           "what they gain on it in 1.5 s; 0: none does"});
    v.retired({"outwalked_speed"}, "it is called assumed_pedestrian_speed");
    v.retired({"outwalked_time", "assumed_pedestrian_time", "uncertainty_in_choice"},
              "a constant of prediction_options.hpp");
  }
};

/// Those of `eteb`: predictions that grow unsure, and people who outwalk a slow robot.
inline PredictionOptions default_eteb_prediction() {
  return {.uncertainty_factor = 1.0, .assumed_pedestrian_speed = 1.0, .uncertainty_growth = 0.1};
}

/// What people who turn towards a robot of top speed `v_max` [m/s] gain on it before it is out of their way
/// [m]: by so much more it keeps from movers (theory.md 6.5).
inline double pedestrian_lead(const PredictionOptions& options, double v_max) {
  return options.kAssumedPedestrianTime * std::max(0.0, options.assumed_pedestrian_speed - v_max);
}

}  // namespace bw::teb
