#include "runtime/cli/outside.hpp"

#include <algorithm>
#include <thread>

namespace bw::cli {
namespace {

bool owns(const std::vector<dds::Guid>& guids, const dds::Guid& guid) {
  return std::ranges::find(guids, guid) != guids.end();
}

std::string full_name(const NodeEntities& node) {
  return (node.node_namespace == "/" ? "" : node.node_namespace) + "/" + node.name;
}

}  // namespace

Outside::Outside() : participant_({.network = dds::Network::from_environment(dds::Transport::localhost)}) {
  Qos qos = Qos::latched();
  qos.depth = 1000;  // one sample of every participant
  node_reader_ = participant_.create_reader(
      {.topic = kDiscoveryTopic, .type = kDiscoveryType, .qos = qos, .user_data = {}}, [] {});
}

void Outside::settle(std::chrono::milliseconds limit) {
  using namespace std::chrono_literals;
  const auto end = std::chrono::steady_clock::now() + limit;
  const auto earliest = std::chrono::steady_clock::now() + 1300ms;  // one announcement period and a little
  std::size_t known = 0;
  auto last_change = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(50ms);
    const auto now = std::chrono::steady_clock::now();
    const std::size_t count = participant_.endpoints().size();
    if (count != known) {
      known = count;
      last_change = now;
    }
    if (now > earliest && now - last_change > 500ms) return;
  }
}

std::vector<dds::Endpoint> Outside::endpoints(bool all) const {
  std::vector<dds::Endpoint> result;
  for (dds::Endpoint& endpoint : participant_.endpoints()) {
    if (endpoint.is_local || (!all && !endpoint.topic.starts_with("rt/"))) continue;
    result.push_back(std::move(endpoint));
  }
  return result;
}

std::vector<ParticipantEntities> Outside::nodes() {
  dds::Sample sample;
  while (node_reader_->take(sample)) {
    auto entities = decode_participant_entities(sample.cdr);
    if (!entities) continue;
    std::erase_if(nodes_, [&](const auto& known) { return known.participant == entities->participant; });
    nodes_.push_back(std::move(*entities));
  }
  return nodes_;
}

std::string Outside::node_of(const dds::Guid& endpoint) {
  for (const ParticipantEntities& participant : nodes()) {
    for (const NodeEntities& node : participant.nodes) {
      if (owns(node.readers, endpoint) || owns(node.writers, endpoint)) return full_name(node);
    }
  }
  return "_NODE_NAME_UNKNOWN_";
}

std::string ros_type(const std::string& dds_type) {
  const std::size_t marker = dds_type.find("::dds_::");
  if (marker == std::string::npos || !dds_type.ends_with('_')) return dds_type;
  std::string name =
      dds_type.substr(0, marker) + "/" + dds_type.substr(marker + 8, dds_type.size() - marker - 9);
  for (std::size_t at = name.find("::"); at != std::string::npos; at = name.find("::"))
    name.replace(at, 2, "/");
  return name;
}

std::string ros_topic(const std::string& dds_topic) {
  return dds_topic.starts_with("rt/") ? dds_topic.substr(2) : dds_topic;
}

}  // namespace bw::cli
