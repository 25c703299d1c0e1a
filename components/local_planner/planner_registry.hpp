// Local planners by the name that `local_planner.algorithm` gives them: those of this tree, and those in a
// library of another project that a graph names under `plugins:`. All join in the same way:
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
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "components/local_planner/checked_planner.hpp"
#include "components/local_planner/driving.hpp"
#include "components/model/planning.hpp"
#include "runtime/base/any_options.hpp"

namespace bw {

/// Sections of parameters by name.
using PlannerSections = std::map<std::string, AnyOptions, std::less<>>;

/// What planners are made with: what they share, and the sections of all of them, at first at their defaults.
/// Planners registered later are not in it.
class PlannerOptions {
 public:
  PlannerOptions();

  /// The section, which holds a T. Throws std::out_of_range for one that nobody registered.
  template <class T>
  const T& of(std::string_view section) const {
    return at(section).template as<T>();
  }
  template <class T>
  T& of(std::string_view section) {
    return const_cast<T&>(std::as_const(*this).of<T>(section));
  }
  template <class Visitor>
  void fields(Visitor& v) {
    driving.fields(v);
    for (auto& [name, options] : sections_) v(name, options, {.doc = "parameters of one planner or idea"});
  }

  DrivingOptions driving;

 private:
  const AnyOptions& at(std::string_view section) const;

  PlannerSections sections_;
};

/// May read sections that others registered, too.
using PlannerMaker = std::function<std::unique_ptr<LocalPlanner>(const PlannerOptions&)>;

/// `sections` are those that come with it, at their defaults. Throws std::logic_error when another one has
/// that name, or one of those sections.
bool register_planner(std::string_view name, PlannerSections sections, PlannerMaker make);

template <class Planner, class Options>
bool register_planner_type(std::string_view name) {
  const std::string section(name);
  return register_planner(name, {{section, AnyOptions(Options{})}}, [section](const PlannerOptions& o) {
    return std::make_unique<Planner>(o.of<Options>(section), o.driving);
  });
}

/// Planners that are no class but a program of its own, named by a path ("./follower.py"): whoever can start such
/// processes says how.
struct PlannerPrograms {
  std::string (*fault_of)(std::string_view path);  ///< why it cannot be started; empty: it can
  std::unique_ptr<LocalPlanner> (*make)(std::string_view path, const DrivingOptions& driving);
};
bool register_planner_programs(const PlannerPrograms& programs);

/// The path of a program, and no name: it has a slash.
inline bool is_planner_program(std::string_view name) { return name.find('/') != std::string_view::npos; }

/// What messages call it: the name, or of a program its file's, wherever that lies.
inline std::string planner_label(std::string_view name) {
  return std::string(name.substr(name.rfind('/') + 1));
}

/// Why such a program cannot be started, or nobody here starts any; empty where it can, and for a name.
std::string planner_program_fault(std::string_view name);

/// As the parameter `algorithm` knows them, sorted; the texts live as long as the program.
std::vector<std::string_view> planner_names();

/// Throws std::runtime_error naming the known planners when `name` is none of them, and no program that can be started.
std::unique_ptr<LocalPlanner> make_planner(std::string_view name, const PlannerOptions& options);

}  // namespace bw

/// Makes a planner class known when its library is loaded. One per class, at namespace scope.
#define BW_PLANNER(planner, options, name) \
  static const bool bw_registered_##planner = ::bw::register_planner_type<planner, options>(name);
