#include "components/local_planner/teb/band_problem.hpp"

#include "components/local_planner/teb/band_evaluation.hpp"

namespace bw::teb {

BandProblem::BandProblem(const Band& band, const BandScene& the_scene, const BandOptions& options,
                         double obstacle_growth)
    : poses(band.size()),
      scene(the_scene),
      segment_model(options, the_scene.limits),
      clearance_model(options, the_scene.obstacles->footprint, obstacle_growth),
      terms(associate(band, *the_scene.obstacles, options)) {}

BandCost BandProblem::cost(const BandPose* at) const {
  BandEvaluation evaluation(*this);
  evaluation.evaluate(at);
  return evaluation.cost();
}

}  // namespace bw::teb
