// The planners of the elastic band, each by what it adds to another.
#include <memory>

#include "components/local_planner/planner_registry.hpp"
#include "components/local_planner/teb/band_planner.hpp"
#include "components/local_planner/teb/hrvo_preference.hpp"

namespace bw::teb {
namespace {

// One band, among movers where they will be or, if asked, as if they stood.
BandPlannerOptions teb(const PlannerOptions& o) {
  BandPlannerOptions planner{.driving = o.driving, .teb = o.of<TebOptions>("teb")};
  if (!planner.teb.include_dynamic_obstacles) planner.field.prediction = Prediction::present;
  return planner;
}

// A band in each of the best topologies (6.2), and a choice between them (3.10).
BandPlannerOptions teb_homotopy(const PlannerOptions& o) {
  const auto& homotopy = o.of<homotopy::HomotopyOptions>("homotopy");
  BandPlannerOptions planner = teb(o);
  planner.source = band_per_topology(homotopy, planner.teb.band);
  planner.selection = selection_of(homotopy);
  return planner;
}

// A term of that choice: the direction that HRVO advises (6.4, 3.12).
BandPlannerOptions pteb(const PlannerOptions& o) {
  BandPlannerOptions planner = teb_homotopy(o);
  planner.term = hrvo_preference(o.of<hrvo::HrvoOptions>("hrvo"), kHrvoAngleWeight);
  return planner;
}

// Another field of obstacles: predictions, and how sure they are (6.5).
BandPlannerOptions eteb(const PlannerOptions& o) {
  BandPlannerOptions planner = teb_homotopy(o);
  planner.field = o.of<PredictionOptions>("eteb");
  return planner;
}

template <BandPlannerOptions (*kOptions)(const PlannerOptions&)>
std::unique_ptr<LocalPlanner> make(const PlannerOptions& o) {
  return std::make_unique<BandPlanner>(kOptions(o));
}

const bool kTeb = register_planner("teb", {{"teb", AnyOptions(TebOptions{})}}, make<teb>);
const bool kTebHomotopy = register_planner(
    "teb_homotopy", {{"homotopy", AnyOptions(homotopy::HomotopyOptions{})}}, make<teb_homotopy>);
const bool kPteb = register_planner("pteb", {}, make<pteb>);
const bool kEteb = register_planner("eteb", {{"eteb", AnyOptions(default_eteb_prediction())}}, make<eteb>);

}  // namespace
}  // namespace bw::teb
