#include "components/local_planner/planner_factory.hpp"

#include <stdexcept>

#include "components/local_planner/teb/teb_planner.hpp"

namespace bw {

std::vector<std::string> planner_names() { return {"teb"}; }

std::unique_ptr<LocalPlanner> make_planner(const std::string& name, const LocalPlannerOptions& options) {
  if (name == "teb") return std::make_unique<teb::TebPlanner>(options.teb);
  std::string known;
  for (const std::string& candidate : planner_names()) known += (known.empty() ? "" : ", ") + candidate;
  throw std::runtime_error("unknown local planner '" + name + "'; known: " + known);
}

}  // namespace bw
