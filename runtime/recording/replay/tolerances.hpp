// By how much the outputs of a replay may differ from the recorded ones: the section `tolerances` of a graph.
//
//   tolerances:
//     /odometry/filtered: {pose.pose.position: 0.01, twist: 0.02}
//     /local_plan_info: {solve_time: left_out}
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/parameters/config_node.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw::replay {

/// Fields are named without indexes (ranges, tracks.position.x); a name stands for all below it, the longest
/// one counts.
/// A stamp or duration is one field [s].
struct TopicTolerances {
  std::map<std::string, double> absolute;  ///< in the field's unit; missing: exact
  std::vector<std::string> left_out;       ///< fields that cannot repeat, such as CPU times

  [[nodiscard]] bool leaves_out(const std::string& field) const;
  /// 0: exact.
  [[nodiscard]] double allowed(const std::string& field) const;
};

using Tolerances = std::map<std::string, TopicTolerances>;  ///< by topic

/// Throws ConfigError: a field that the topic's type does not have, a tolerance that is neither a number of
/// at least 0 nor `left_out`. Topics that are not in `topics` are not looked at further.
[[nodiscard]] Tolerances read_tolerances(const ConfigNode& section, const std::vector<bag::BagTopic>& topics);

}  // namespace bw::replay
