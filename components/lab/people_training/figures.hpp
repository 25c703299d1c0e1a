// How well a classifier and a detector do.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace bw::people {

/// Of scores against truth: threshold 0.5 for precision and recall.
struct ClassifierFigures {
  double area = 0.0;  ///< under the ROC curve; ties count half
  double precision = 0.0;
  double recall = 0.0;
  int positives = 0;
  int negatives = 0;
};
ClassifierFigures figures_of(std::span<const double> scores, std::span<const std::uint8_t> positive);

/// Of whole sweeps, people within 6 m of whom at least half of the beams that could do so end on them.
struct PeopleFigures {
  int people = 0;      ///< sightings that should be
  int found = 0;       ///< with a leg or body of score >= 0.5 within 0.3 m of the middle between the legs
  int detections = 0;  ///< of score >= 0.5 within 6 m, not on the background
  int right = 0;       ///< on somebody: within 0.4 m of the middle
  int legs = 0;        ///< clusters that are one leg and were taken as such
  double leg_bias_away = 0.0;  ///< mean error of those legs along the line of sight, away positive [m]
  double leg_bias_left = 0.0;  ///< and to the left [m]
  double leg_error = 0.0;      ///< root mean square distance from the truth [m]
  double leg_nees = 0.0;       ///< mean squared error in units of the covariance: 2 when that is honest
  int bodies = 0;
  double body_error = 0.0;  ///< root mean square distance of bodies from the middle between the legs [m]

  double recall() const { return people > 0 ? static_cast<double>(found) / people : 0.0; }
  double precision() const { return detections > 0 ? static_cast<double>(right) / detections : 0.0; }
};

struct Trial {
  std::uint64_t first_seed = 1;
  int rooms = 1;
  int sweeps = 100;
  bool varied_scanner = true;
  bool moving = true;
  int most_people = 20;
};
PeopleFigures try_detector(const Trial& trial);

}  // namespace bw::people
