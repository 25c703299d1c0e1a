// The planners of the dynamic window: EDWA is DWA with another source of its heading and velocity terms.
#include <memory>

#include "components/local_planner/dwa/critics_planner.hpp"
#include "components/local_planner/dwa/dwa_planner.hpp"
#include "components/local_planner/planner_factory.hpp"
#include "components/local_planner/planner_registry.hpp"

namespace bw::dwa {
namespace {

std::unique_ptr<LocalPlanner> make_dwa(const LocalPlannerOptions& o) {
  if (o.dwa.profile == Profile::critics) return std::make_unique<CriticsPlanner>(o.dwa, o.driving);
  return std::make_unique<DwaPlanner>(o.dwa, o.driving, towards_aim(o.driving));
}

std::unique_ptr<LocalPlanner> make_edwa(const LocalPlannerOptions& o) {
  if (o.dwa.profile == Profile::critics)
    return std::make_unique<CriticsPlanner>(o.dwa, o.driving, o.edwa, o.hrvo);
  return std::make_unique<DwaPlanner>(o.dwa, o.driving, towards_hrvo(o.edwa, o.hrvo, o.driving));
}

const bool kDwa = register_planner("dwa", make_dwa);
const bool kEdwa = register_planner("edwa", make_edwa);

}  // namespace
}  // namespace bw::dwa
