#include "components/lab/bench/planner_overrides.hpp"

#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/parameters.hpp"

namespace bw {

void apply_overrides(PlannerOptions& options, const std::vector<std::string>& set) {
  ConfigNode root;
  for (const std::string& text : set) apply_override(root, parse_override(text));
  read_into(options, root, "");
}

}  // namespace bw
