// The parameters of a running node, asked for and changed over the services that every node of ROS 2 has.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <rcl_interfaces/msg/parameter_descriptor.hpp>
#include <rcl_interfaces/msg/set_parameters_result.hpp>

#include "runtime/dds/participant.hpp"
#include "runtime/parameters/parameter_set.hpp"

namespace bw::cli {

/// Every call throws std::runtime_error when the node does not answer within the limit.
class ParameterClient {
 public:
  static constexpr std::chrono::milliseconds kLimit{5000};

  /// `node` with or without the slash in front.
  ParameterClient(dds::Participant& participant, const std::string& node);

  const std::string& node() const { return node_; }  ///< its full name
  std::vector<std::string> names();
  /// Empty when one of the names is unknown.
  std::vector<ParameterValue> values(const std::vector<std::string>& names);
  std::vector<rcl_interfaces::msg::ParameterDescriptor> descriptors(const std::vector<std::string>& names);
  std::vector<rcl_interfaces::msg::SetParametersResult> set(const std::vector<NamedValue>& parameters);

 private:
  template <class S>
  typename S::Response call(const char* service, const typename S::Request& request);

  dds::Participant& participant_;
  std::string node_;
};

}  // namespace bw::cli
