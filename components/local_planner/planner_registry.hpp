// How a local planner joins those that `local_planner.algorithm` chooses from, in this tree or in a library of
// another project that a graph names under `plugins:`.
//
//   struct FollowerOptions { ... template <class Visitor> void fields(Visitor& v) { ... } };
//   class Follower final : public bw::CheckedPlanner {
//    public:
//     Follower(const FollowerOptions& options, const bw::DrivingOptions& driving);
//     ...
//   };
//   BW_PLANNER(Follower, FollowerOptions, "follower")
//
// Its parameters stand in a section of that name among those of local_planner. No middleware: a planner is an
// algorithm.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "components/local_planner/checked_planner.hpp"
#include "components/model/planning.hpp"
#include "runtime/base/any_options.hpp"

namespace bw {

struct LocalPlannerOptions;

/// A planner whose parameters are its own `options` and what all planners share. Throws std::logic_error when
/// another one has that name; `options` holds the defaults.
using PlannerOfOwnOptions =
    std::function<std::unique_ptr<LocalPlanner>(const AnyOptions& options, const DrivingOptions& driving)>;
bool register_planner(std::string_view name, const AnyOptions& options, PlannerOfOwnOptions make);

/// A planner of this tree, whose sections LocalPlannerOptions names.
using PlannerOfAllOptions = std::function<std::unique_ptr<LocalPlanner>(const LocalPlannerOptions&)>;
bool register_planner(std::string_view name, PlannerOfAllOptions make);

template <class Planner, class Options>
bool register_planner_type(std::string_view name) {
  return register_planner(name, AnyOptions(Options{}),
                          [](const AnyOptions& options, const DrivingOptions& driving) {
                            return std::make_unique<Planner>(options.as<Options>(), driving);
                          });
}

}  // namespace bw

/// Makes a planner class known when its library is loaded. One per class, at namespace scope.
#define BW_PLANNER(planner, options, name) \
  static const bool bw_registered_##planner = ::bw::register_planner_type<planner, options>(name);
