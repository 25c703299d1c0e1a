#include "components/local_planner/planner_registry.hpp"

#include <optional>
#include <stdexcept>
#include <utility>

namespace bw {
namespace {

struct Registry {
  std::map<std::string, PlannerMaker, std::less<>> planners;
  PlannerSections sections;
  std::optional<PlannerPrograms> programs;
};

// Built when the first planner asks for it: planners register before main(), in no fixed order.
Registry& registry() {
  static Registry all;
  return all;
}

}  // namespace

bool register_planner(std::string_view name, PlannerSections sections, PlannerMaker make) {
  Registry& all = registry();
  for (const auto& [section, defaults] : sections) {
    if (all.sections.contains(section))
      throw std::logic_error("two local planners have parameters in a section " + section);
  }
  if (!all.planners.emplace(name, std::move(make)).second)
    throw std::logic_error("two local planners call themselves " + std::string(name));
  all.sections.merge(sections);
  return true;
}

PlannerOptions::PlannerOptions() : sections_(registry().sections) {}

const AnyOptions& PlannerOptions::at(std::string_view section) const {
  const auto found = sections_.find(section);
  if (found == sections_.end())
    throw std::out_of_range("no local planner has parameters in a section " + std::string(section));
  return found->second;
}

bool register_planner_programs(const PlannerPrograms& programs) {
  registry().programs = programs;
  return true;
}

std::string planner_program_fault(std::string_view name) {
  if (!is_planner_program(name)) return "";
  return registry().programs ? registry().programs->fault_of(name) : "planner processes are not started here";
}

std::vector<std::string_view> planner_names() {
  std::vector<std::string_view> names;
  for (const auto& [name, make] : registry().planners) names.push_back(name);
  return names;
}

std::unique_ptr<LocalPlanner> make_planner(std::string_view name, const PlannerOptions& options) {
  if (is_planner_program(name)) {
    const std::string fault = planner_program_fault(name);
    if (!fault.empty()) throw std::runtime_error(std::string(name) + ": " + fault);
    return registry().programs->make(name, options.driving);
  }
  const auto& planners = registry().planners;
  if (const auto found = planners.find(name); found != planners.end()) return found->second(options);
  std::string known;
  for (const std::string_view one : planner_names()) known.append(known.empty() ? "" : ", ").append(one);
  throw std::runtime_error("unknown local planner '" + std::string(name) + "'; known: " + known);
}

}  // namespace bw
