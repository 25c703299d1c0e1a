#include "runtime/cli/parameter_client.hpp"

#include <stdexcept>

#include <rcl_interfaces/srv/describe_parameters.hpp>
#include <rcl_interfaces/srv/get_parameters.hpp>
#include <rcl_interfaces/srv/list_parameters.hpp>
#include <rcl_interfaces/srv/set_parameters.hpp>

#include "runtime/ros/parameter_messages.hpp"
#include "runtime/ros/service_call.hpp"

namespace bw::cli {

using namespace rcl_interfaces::srv;

ParameterClient::ParameterClient(dds::Participant& participant, const std::string& node)
    : participant_(participant), node_(node.starts_with('/') ? node : "/" + node) {}

template <class S>
typename S::Response ParameterClient::call(const char* service, const typename S::Request& request) {
  auto response = call_service<S>(participant_, node_ + "/" + service, request, kLimit);
  if (!response) throw std::runtime_error("no node " + node_ + " answers on " + node_ + "/" + service);
  return std::move(*response);
}

std::vector<std::string> ParameterClient::names() {
  return call<ListParameters>("list_parameters", {}).result().names();
}

std::vector<ParameterValue> ParameterClient::values(const std::vector<std::string>& names) {
  GetParameters::Request request;
  request.names(names);
  const GetParameters::Response response = call<GetParameters>("get_parameters", request);
  std::vector<ParameterValue> values;
  for (const auto& value : response.values()) values.push_back(from_message(value));
  return values;
}

std::vector<rcl_interfaces::msg::ParameterDescriptor> ParameterClient::descriptors(
    const std::vector<std::string>& names) {
  DescribeParameters::Request request;
  request.names(names);
  return call<DescribeParameters>("describe_parameters", request).descriptors();
}

std::vector<rcl_interfaces::msg::SetParametersResult> ParameterClient::set(
    const std::vector<NamedValue>& parameters) {
  SetParameters::Request request;
  for (const NamedValue& parameter : parameters) request.parameters().push_back(to_message(parameter));
  return call<SetParameters>("set_parameters", request).results();
}

}  // namespace bw::cli
