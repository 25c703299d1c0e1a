// Local planners by the name a graph gives them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/local_planner/teb/teb_options.hpp"
#include "components/model/planning.hpp"

namespace bw {

/// Parameters of all local planners; each reads its own section.
struct LocalPlannerOptions {
  dwa::DwaOptions dwa;
  dwa::EdwaOptions edwa;
  hrvo::HrvoOptions hrvo;
  teb::TebOptions teb;

  template <class Visitor>
  void fields(Visitor& v) {
    v("dwa", dwa, {.doc = "dynamic window approach"});
    v("edwa", edwa, {.doc = "what EDWA changes in it"});
    v("hrvo", hrvo, {.doc = "hybrid reciprocal velocity obstacles"});
    v("teb", teb, {.doc = "timed elastic band"});
  }
};

/// As the parameter `algorithm` knows them; the texts live as long as the program.
std::vector<std::string_view> planner_names();

/// Throws std::runtime_error naming the known planners when `name` is none of them.
std::unique_ptr<LocalPlanner> make_planner(std::string_view name, const LocalPlannerOptions& options);

}  // namespace bw
