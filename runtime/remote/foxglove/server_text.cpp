#include <nlohmann/json.hpp>

#include "runtime/remote/foxglove/parameter_json.hpp"
#include "runtime/remote/foxglove/server_ops.hpp"

namespace bw::foxglove {
namespace {

using nlohmann::ordered_json;

/// Names and texts of others may be any bytes: what is no UTF-8 is replaced.
std::string written(const ordered_json& op) {
  return op.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json schema_json(const ServiceSchema& schema) {
  return {{"encoding", kCdr},
          {"schemaName", schema.schema_name},
          {"schemaEncoding", "ros2msg"},
          {"schema", schema.schema}};
}

using NodesOf = std::map<std::string, std::set<std::string>>;

ordered_json nodes_json(const NodesOf& nodes_of, const char* ids) {
  ordered_json entries = ordered_json::array();
  for (const auto& [name, nodes] : nodes_of) entries.push_back({{"name", name}, {ids, nodes}});
  return entries;
}

}  // namespace

std::string server_info_op(const ServerInfo& info) {
  ordered_json op = {{"op", "serverInfo"},
                     {"name", info.name},
                     {"capabilities", info.capabilities},
                     {"supportedEncodings", {kCdr, kJson}},
                     {"metadata", info.metadata}};
  if (!info.session.empty()) op["sessionId"] = info.session;
  return written(op);
}

std::string status_op(Level level, const std::string& message, const std::string& id) {
  ordered_json op = {{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}};
  if (!id.empty()) op["id"] = id;
  return written(op);
}

std::string remove_status_op(const std::vector<std::string>& ids) {
  return written({{"op", "removeStatus"}, {"statusIds", ids}});
}

std::string advertise_op(std::span<const Channel> channels) {
  ordered_json list = ordered_json::array();
  for (const Channel& channel : channels) {
    ordered_json entry = {{"id", channel.id},
                          {"topic", channel.topic},
                          {"encoding", kCdr},
                          {"schemaName", channel.schema_name},
                          {"schemaEncoding", "ros2msg"},
                          {"schema", channel.schema}};
    if (channel.is_latched) entry["metadata"] = {{"latched", "true"}};
    list.push_back(std::move(entry));
  }
  return written({{"op", "advertise"}, {"channels", std::move(list)}});
}

std::string unadvertise_op(const std::vector<std::uint32_t>& channels) {
  return written({{"op", "unadvertise"}, {"channelIds", channels}});
}

std::string advertise_services_op(std::span<const Service> services) {
  ordered_json list = ordered_json::array();
  for (const Service& service : services) {
    list.push_back({{"id", service.id},
                    {"name", service.name},
                    {"type", service.type},
                    {"request", schema_json(service.request)},
                    {"response", schema_json(service.response)}});
  }
  return written({{"op", "advertiseServices"}, {"services", std::move(list)}});
}

std::string unadvertise_services_op(const std::vector<std::uint32_t>& services) {
  return written({{"op", "unadvertiseServices"}, {"serviceIds", services}});
}

std::string parameter_values_op(const std::vector<NamedValue>& parameters,
                                const std::optional<std::string>& request) {
  ordered_json list = ordered_json::array();
  for (const NamedValue& parameter : parameters) list.push_back(parameter_json(parameter));
  ordered_json op = {{"op", "parameterValues"}, {"parameters", std::move(list)}};
  if (request) op["id"] = *request;
  return written(op);
}

std::string graph_update_op(const GraphDifference& difference) {
  return written({{"op", "connectionGraphUpdate"},
                  {"publishedTopics", nodes_json(difference.changed.published, "publisherIds")},
                  {"subscribedTopics", nodes_json(difference.changed.subscribed, "subscriberIds")},
                  {"advertisedServices", nodes_json(difference.changed.services, "providerIds")},
                  {"removedTopics", difference.removed_topics},
                  {"removedServices", difference.removed_services}});
}

std::string service_failure_op(std::uint32_t service, std::uint32_t call, const std::string& message) {
  return written(
      {{"op", "serviceCallFailure"}, {"serviceId", service}, {"callId", call}, {"message", message}});
}

}  // namespace bw::foxglove
