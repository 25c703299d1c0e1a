#include "components/local_planner/follow_path/plugin_choice.hpp"

#include <algorithm>
#include <vector>

namespace bw {
namespace {

using Names = std::vector<std::string>;

bool is_known(const std::string& id, const Names& configured) {
  if (id.empty()) return configured.size() <= 1;
  return std::find(configured.begin(), configured.end(), id) != configured.end();
}

std::string refusal(const std::string& what, const std::string& id, const Names& configured) {
  std::string all;
  for (const std::string& name : configured) all += (all.empty() ? "" : ", ") + name;
  if (id.empty()) return "the goal names no " + what + ", and there are " + all;
  return "the " + what + " '" + id + "' is unknown; there is " + (all.empty() ? "none" : all);
}

}  // namespace

FollowFailure unknown_plugin(const PluginIds& ids, const FollowPathOptions& options) {
  if (!is_known(ids.controller, options.controller_plugins))
    return {FollowFault::invalid_controller,
            refusal("controller", ids.controller, options.controller_plugins)};
  const struct {
    const char* what;
    const std::string& id;
    const Names& configured;
  } others[] = {{"goal checker", ids.goal_checker, options.goal_checker_plugins},
                {"progress checker", ids.progress_checker, options.progress_checker_plugins},
                {"path handler", ids.path_handler, options.path_handler_plugins}};
  for (const auto& [what, id, configured] : others) {
    if (!is_known(id, configured)) return {FollowFault::unknown, refusal(what, id, configured)};
  }
  return {};
}

}  // namespace bw
