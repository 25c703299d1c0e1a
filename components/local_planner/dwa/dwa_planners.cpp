// The planners of the dynamic window: EDWA is DWA with another source of its heading and velocity terms.
#include <memory>

#include "components/local_planner/dwa/critics_planner.hpp"
#include "components/local_planner/dwa/dwa_planner.hpp"
#include "components/local_planner/planner_registry.hpp"

namespace bw::dwa {
namespace {

std::unique_ptr<LocalPlanner> make_dwa(const PlannerOptions& o) {
  const auto& dwa = o.of<DwaOptions>("dwa");
  if (dwa.profile == Profile::critics) return std::make_unique<CriticsPlanner>(dwa, o.driving);
  return std::make_unique<DwaPlanner>(dwa, o.driving, towards_aim(o.driving));
}

std::unique_ptr<LocalPlanner> make_edwa(const PlannerOptions& o) {
  const auto& dwa = o.of<DwaOptions>("dwa");
  const auto& edwa = o.of<EdwaOptions>("edwa");
  const auto& hrvo = o.of<hrvo::HrvoOptions>("hrvo");
  if (dwa.profile == Profile::critics) return std::make_unique<CriticsPlanner>(dwa, o.driving, edwa, hrvo);
  return std::make_unique<DwaPlanner>(dwa, o.driving, towards_hrvo(edwa, hrvo, o.driving));
}

const bool kDwa = register_planner("dwa", {{"dwa", AnyOptions(DwaOptions{})}}, make_dwa);
const bool kEdwa = register_planner("edwa", {{"edwa", AnyOptions(EdwaOptions{})}}, make_edwa);

}  // namespace
}  // namespace bw::dwa
