#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/cli/outside.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/yaml_file.hpp"
#include "runtime/ros/message_from_yaml.hpp"
#include "runtime/ros/service_call.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/yaml.hpp"

namespace bw::cli {
namespace {

constexpr std::string_view kRequestSuffix = "_Request";

struct ServiceOptions {
  std::string name;
  std::string type;
  std::string request = "{}";
  bool types = false;
  bool json = false;
  double timeout_s = 5.0;
};

/// nav_msgs/srv/GetMap_Request -> nav_msgs/srv/GetMap
std::string service_type_name(const std::string& request_type) {
  return request_type.ends_with(kRequestSuffix)
             ? request_type.substr(0, request_type.size() - kRequestSuffix.size())
             : request_type;
}

/// Types of the services that somebody offers, by name.
std::map<std::string, std::string> services(Outside& outside) {
  std::map<std::string, std::string> found;
  for (const dds::Endpoint& end : outside.endpoints(true)) {
    const std::string name = service_of_request(end.topic);
    if (!name.empty() && !end.is_writer) found[name] = service_type_name(ros_type(end.type));
  }
  return found;
}

void list(const ServiceOptions& options) {
  Outside outside;
  outside.settle();
  const auto found = services(outside);
  if (options.json) {
    std::cout << nlohmann::json(found).dump(2) << "\n";
    return;
  }
  for (const auto& [name, type] : found)
    std::cout << (options.types ? fmt::format("{} [{}]\n", name, type) : name + "\n");
}

int call(ServiceOptions options) {
  Outside outside;
  std::map<std::string, std::string> found;
  outside.settle([&] {
    found = services(outside);
    return found.contains(options.name);
  });
  const auto offered = found.find(options.name);
  if (offered == found.end()) {
    std::vector<std::string_view> names;
    for (const auto& [name, type] : found) names.push_back(name);
    throw std::runtime_error(options.name + ": " + unknown_rule("service", options.name, names));
  }
  // One argument behind the name is the request where it is no type's name.
  if (options.type.find('{') != std::string::npos) options.request = std::exchange(options.type, "");
  if (options.type.empty()) options.type = offered->second;
  if (options.type != offered->second) {
    throw std::runtime_error(
        fmt::format("{} is a {}, not a {}", options.name, offered->second, options.type));
  }
  const TypeDescription* request = find_type(options.type + "_Request");
  const TypeDescription* response = find_type(options.type + "_Response");
  if (request == nullptr || response == nullptr)
    throw std::runtime_error(options.type + ": this program does not know the type");
  const auto type_of = [](const TypeDescription& t) {
    return MessageType{t.ros_name, t.dds_name, t.type_hash};
  };
  const auto reply = call_service(
      outside.participant(), options.name,
      {.ros_name = options.type, .request = type_of(*request), .response = type_of(*response), .event = {}},
      message_from_yaml(*request, parse_yaml(options.request, "request")),
      std::chrono::milliseconds(static_cast<std::int64_t>(options.timeout_s * 1e3)));
  if (!reply) {
    std::cerr << options.name << " did not answer within " << options.timeout_s << " s\n";
    return 1;
  }
  std::cout << to_yaml(*response, *reply);
  return 0;
}

void add_service(Verb service) {
  auto options = std::make_shared<ServiceOptions>();
  Verb list_verb = service.verb("list", "Names of all services");
  list_verb.flag("-t,--show-types", options->types, "With types");
  list_verb.flag("--json", options->json, "As JSON");
  list_verb.run([options] { list(*options); });
  Verb call_verb = service.verb("call", "Calls a service and prints its reply; exit status 1 without one");
  call_verb.option("SERVICE", options->name, "Name, such as /map_server/load_map").required();
  call_verb.option("TYPE", options->type, "Type, such as nav_msgs/srv/LoadMap; default: as offered");
  call_verb.option("REQUEST", options->request, "Its fields as YAML; what is not given is zero");
  call_verb.option("--timeout", options->timeout_s, "Longest wait for the reply [s]");
  call_verb.run([options] { return call(*options); });
}

}  // namespace

BW_VERB(look, "service", "Services on the wire", add_service)

}  // namespace bw::cli
