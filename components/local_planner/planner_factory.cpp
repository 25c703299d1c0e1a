#include "components/local_planner/planner_factory.hpp"

#include <stdexcept>
#include <utility>

#include "components/local_planner/planner_registry.hpp"

namespace bw {
namespace {

struct RegisteredPlanner {
  AnyOptions options;  // of its own, if it has any
  PlannerOfAllOptions make;
};

// Built when the first planner asks for it: planners register before main(), in no fixed order.
std::map<std::string, RegisteredPlanner, std::less<>>& planners() {
  static std::map<std::string, RegisteredPlanner, std::less<>> all;
  return all;
}

bool add(std::string_view name, RegisteredPlanner planner) {
  if (!planners().emplace(name, std::move(planner)).second)
    throw std::logic_error("two local planners call themselves " + std::string(name));
  return true;
}

}  // namespace

bool register_planner(std::string_view name, PlannerOfAllOptions make) {
  return add(name, {{}, std::move(make)});
}

bool register_planner(std::string_view name, const AnyOptions& options, PlannerOfOwnOptions make) {
  return add(name,
             {options, [name = std::string(name), make = std::move(make)](const LocalPlannerOptions& o) {
                return make(o.others.of(name), o.driving);
              }});
}

PlannerSections::PlannerSections() {
  for (const auto& [name, planner] : planners()) {
    if (!planner.options.empty()) sections_.emplace(name, planner.options);
  }
}

std::vector<std::string_view> planner_names() {
  std::vector<std::string_view> names;
  for (const auto& [name, planner] : planners()) names.push_back(name);
  return names;
}

std::unique_ptr<LocalPlanner> make_planner(std::string_view name, const LocalPlannerOptions& options) {
  if (const auto found = planners().find(name); found != planners().end()) return found->second.make(options);
  std::string known;
  for (const std::string_view one : planner_names()) known.append(known.empty() ? "" : ", ").append(one);
  throw std::runtime_error("unknown local planner '" + std::string(name) + "'; known: " + known);
}

}  // namespace bw
