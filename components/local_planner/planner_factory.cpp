#include "components/local_planner/planner_factory.hpp"

#include <stdexcept>

#include "components/local_planner/dwa/dwa_planner.hpp"
#include "components/local_planner/hrvo/hrvo_planner.hpp"
#include "components/local_planner/teb/band_planner.hpp"

namespace bw {
namespace {

using Made = std::unique_ptr<LocalPlanner>;

// What all planners of the band share.
teb::BandPlannerOptions band_planner(const LocalPlannerOptions& o) {
  teb::BandPlannerOptions options{.driving = o.driving, .teb = o.teb};
  if (!o.teb.include_dynamic_obstacles) options.prediction.prediction = "present";
  return options;
}

struct NamedPlanner {
  std::string_view name;
  Made (*make)(const LocalPlannerOptions& options);
};

/// A new planner is one line here, and its section in LocalPlannerOptions.
const NamedPlanner kPlanners[] = {
    {"dwa",
     [](const LocalPlannerOptions& o) -> Made {
       return std::make_unique<dwa::DwaPlanner>(o.dwa, o.driving);
     }},
    {"edwa",
     [](const LocalPlannerOptions& o) -> Made {
       return std::make_unique<dwa::DwaPlanner>(o.dwa, o.driving, o.edwa, o.hrvo);
     }},
    {"hrvo",
     [](const LocalPlannerOptions& o) -> Made {
       return std::make_unique<hrvo::HrvoPlanner>(o.hrvo, o.driving);
     }},
    {"teb",
     [](const LocalPlannerOptions& o) -> Made {
       return std::make_unique<teb::BandPlanner>(band_planner(o));
     }},
    {"teb_homotopy",
     [](const LocalPlannerOptions& o) -> Made {
       teb::BandPlannerOptions options = band_planner(o);
       options.homotopy = o.homotopy;
       return std::make_unique<teb::BandPlanner>(options);
     }},
    {"pteb",
     [](const LocalPlannerOptions& o) -> Made {
       teb::BandPlannerOptions options = band_planner(o);
       options.homotopy = o.homotopy;
       options.hrvo = {o.hrvo, o.pteb.hrvo_angle_weight};
       return std::make_unique<teb::BandPlanner>(options);
     }},
    {"eteb",
     [](const LocalPlannerOptions& o) -> Made {
       teb::BandPlannerOptions options = band_planner(o);
       options.homotopy = o.homotopy;
       options.prediction = o.eteb;
       return std::make_unique<teb::BandPlanner>(options);
     }},
};

}  // namespace

std::vector<std::string_view> planner_names() {
  std::vector<std::string_view> names;
  for (const NamedPlanner& planner : kPlanners) names.push_back(planner.name);
  return names;
}

std::unique_ptr<LocalPlanner> make_planner(std::string_view name, const LocalPlannerOptions& options) {
  std::string known;
  for (const NamedPlanner& planner : kPlanners) {
    if (planner.name == name) return planner.make(options);
    known.append(known.empty() ? "" : ", ").append(planner.name);
  }
  throw std::runtime_error("unknown local planner '" + std::string(name) + "'; known: " + known);
}

}  // namespace bw
