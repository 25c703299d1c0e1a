#include "runtime/cli/param_node.hpp"

#include <array>
#include <iostream>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "runtime/cli/outside.hpp"
#include "runtime/cli/parameter_client.hpp"
#include "runtime/parameters/parameter_file.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw::cli {
namespace {

/// As ROS 2's tools call the types.
std::string_view ros_name_of(ParameterType type) {
  constexpr std::array<std::string_view, 10> kNames = {
      "not set",    "boolean",       "integer",       "double",       "string",
      "byte array", "boolean array", "integer array", "double array", "string array"};
  const auto index = static_cast<std::size_t>(type);
  return index < kNames.size() ? kNames[index] : "unknown";
}

std::string capital(std::string_view word) {
  std::string text(word);
  text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// "Double value is: 1.0", "Integer values are: [1, 2]"
std::string value_line(const ParameterValue& value) {
  std::string_view type = ros_name_of(type_of(value));
  const std::size_t array = type.find(" array");
  const bool is_list = array != std::string_view::npos;
  return fmt::format("{} {}: {}", capital(type.substr(0, array)), is_list ? "values are" : "value is",
                     to_yaml_text(value));
}

int not_set(const std::string& node, const std::string& name) {
  std::cerr << node << " has no parameter " << name << "\n";
  return 1;
}

void print_names(ParameterClient& client) {
  for (const std::string& name : client.names()) std::cout << "  " << name << "\n";
}

void print_range(const std::string& from, const std::string& to) {
  std::cout << "    Min value: " << from << "\n    Max value: " << to << "\n";
}

}  // namespace

int list_nodes_parameters() {
  Outside outside;
  outside.settle();
  std::set<std::string> nodes;
  const std::string suffix = "/list_parameters";
  for (const dds::Endpoint& endpoint : outside.endpoints(true)) {
    const std::string service = service_of_request(endpoint.topic);
    if (!endpoint.is_writer && service.ends_with(suffix))
      nodes.insert(service.substr(0, service.size() - suffix.size()));
  }
  for (const std::string& node : nodes) {
    ParameterClient client(outside.participant(), node);
    std::cout << node << ":\n";
    print_names(client);
  }
  return 0;
}

int list_node(const std::string& node) {
  Outside outside;
  ParameterClient client(outside.participant(), node);
  print_names(client);
  return 0;
}

int get_parameter(const std::string& node, const std::string& name) {
  Outside outside;
  ParameterClient client(outside.participant(), node);
  const std::vector<ParameterValue> values = client.values({name});
  if (values.empty() || type_of(values[0]) == ParameterType::not_set) return not_set(client.node(), name);
  std::cout << value_line(values[0]) << "\n";
  return 0;
}

int set_parameter(const std::string& node, const std::string& name, const std::string& value) {
  const ConfigNode given = parse_yaml(value, "VALUE");
  auto typed = parameter_value_of(given);
  if (!typed && given.is_sequence())
    typed = value;  // as ros2 param: lists of lists, such as footprints, are texts
  if (!typed) throw std::runtime_error(value + " is no bool, number, text, nor a list of one of these");
  Outside outside;
  ParameterClient client(outside.participant(), node);
  const auto results = client.set({{name, *typed}});
  if (results.size() != 1) throw std::runtime_error(client.node() + " gives no answer to one parameter");
  if (results[0].successful()) {
    std::cout << "Set parameter successful\n";
    return 0;
  }
  std::cerr << "Setting parameter failed: " << results[0].reason() << "\n";
  return 1;
}

int describe_parameter(const std::string& node, const std::string& name) {
  Outside outside;
  ParameterClient client(outside.participant(), node);
  const auto descriptors = client.descriptors({name});
  if (descriptors.empty()) return not_set(client.node(), name);
  const auto& descriptor = descriptors[0];
  std::cout << "Parameter name: " << descriptor.name()
            << "\n  Type: " << ros_name_of(static_cast<ParameterType>(descriptor.type())) << "\n";
  if (!descriptor.description().empty()) std::cout << "  Description: " << descriptor.description() << "\n";
  std::cout << "  Constraints:\n    Read only: " << to_text(descriptor.read_only()) << "\n";
  for (const auto& range : descriptor.floating_point_range())
    print_range(to_text(range.from_value()), to_text(range.to_value()));
  for (const auto& range : descriptor.integer_range())
    print_range(to_text(range.from_value()), to_text(range.to_value()));
  if (!descriptor.additional_constraints().empty())
    std::cout << "    Additional constraints: " << descriptor.additional_constraints() << "\n";
  return 0;
}

int dump_node(const std::string& node) {
  Outside outside;
  ParameterClient client(outside.participant(), node);
  const std::vector<std::string> names = client.names();
  const std::vector<ParameterValue> values = client.values(names);
  if (values.size() != names.size())
    throw std::runtime_error(client.node() + " does not tell all its parameters");
  std::vector<NamedValue> parameters;
  for (std::size_t i = 0; i < names.size(); ++i) parameters.push_back({names[i], values[i]});
  std::cout << to_parameter_file(client.node(), parameters);
  return 0;
}

int load_node(const std::string& node, const std::string& file) {
  Outside outside;
  ParameterClient client(outside.participant(), node);
  const std::vector<NamedValue> parameters = parameters_of_node(load_yaml(file), client.node());
  const auto results = client.set(parameters);
  if (results.size() != parameters.size())
    throw std::runtime_error(client.node() +
                             (results.empty() ? " gives no answer" : ": " + results[0].reason()));
  int status = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].successful()) {
      std::cout << "Set parameter " << parameters[i].name << " successful\n";
    } else {
      std::cerr << "Setting parameter " << parameters[i].name << " failed: " << results[i].reason() << "\n";
      status = 1;
    }
  }
  return status;
}

}  // namespace bw::cli
