// The ids in a goal of follow_path. In Nav2 each names a plugin with parameters of its own; here the planner
// and its checkers go by all the names that are configured.
#pragma once

#include <string>

#include "components/local_planner/follow_path/follow_fault.hpp"
#include "components/local_planner/follow_path/follow_path_options.hpp"

namespace bw {

struct PluginIds {
  std::string controller;
  std::string goal_checker;
  std::string progress_checker;
  std::string path_handler;
};

/// The first of the ids that is not known; fault `none`: all are. An empty id means the only one, or that
/// none is wanted where there is none. As in Nav2, only an unknown controller has a code of its own.
FollowFailure unknown_plugin(const PluginIds& ids, const FollowPathOptions& options);

}  // namespace bw
