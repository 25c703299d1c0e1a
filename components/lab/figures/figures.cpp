#include "components/lab/figures/figures.hpp"

#include <array>

namespace bw::figures {

std::span<const Figure> all() {
  static constexpr std::array kAll{
      Figure{"elastic_band", "a timed elastic band with its poses and what pushes them", elastic_band},
      Figure{"homotopy_classes", "bands in different homotopy classes around two people", homotopy_classes},
      Figure{"velocity_obstacle", "velocity obstacles with their apexes, and the velocity advised",
             velocity_obstacle},
      Figure{"dynamic_window", "dynamic window, samples and objective", dynamic_window},
      Figure{"late_measurement", "a late position fix in the EKF", late_measurement},
      Figure{"particle_cloud", "particles over a likelihood field", particle_cloud},
      Figure{"leg_evidence", "clusters of a sweep and how human they look", leg_evidence},
      Figure{"stopping_distance", "costmap and stopping distances", stopping_distance}};
  return kAll;
}

}  // namespace bw::figures
