// Parameters of nodes in a file, as ROS 2's tools write and read it (`ros2 param dump|load`,
// `--params-file`):
//
//   /local_planner:
//     ros__parameters:
//       teb:
//         weight_obstacle: 50.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/parameters/parameter_set.hpp"

namespace bw {

/// `node` is a full name. Sections of names become maps.
std::string to_parameter_file(std::string_view node, const std::vector<NamedValue>& parameters);

/// What the file says of the node: under its full name, its name without `/`, nested below its namespace, or
/// under `/**`, which is for all nodes. Throws ConfigError for what is no value of a parameter, and when
/// nothing is said of the node.
std::vector<NamedValue> parameters_of_node(const ConfigNode& file, std::string_view node);

}  // namespace bw
