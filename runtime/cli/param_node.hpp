// `bandwagon param ...` on a running node, as `ros2 param` does it.
#pragma once

#include <string>

namespace bw::cli {

// Each returns the exit status, and throws std::runtime_error when the node does not answer.

/// The parameters of all nodes of the domain that have any.
int list_nodes_parameters();
int list_node(const std::string& node);
int get_parameter(const std::string& node, const std::string& name);
/// `value` as YAML.
int set_parameter(const std::string& node, const std::string& name, const std::string& value);
int describe_parameter(const std::string& node, const std::string& name);
int dump_node(const std::string& node);
int load_node(const std::string& node, const std::string& file);

}  // namespace bw::cli
