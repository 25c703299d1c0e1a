#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "runtime/dds/participant.hpp"

namespace bw::dds {
namespace {

std::optional<std::string> variable(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return value;
}

int parse_domain_id(const std::string& text) {
  std::size_t used = 0;
  int id = -1;
  try {
    id = std::stoi(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used != text.size() || id < 0 || id > 232) {
    throw std::runtime_error("ROS_DOMAIN_ID = \"" + text + "\": must be a whole number from 0 to 232");
  }
  return id;
}

}  // namespace

Network Network::from_environment(Transport configured) {
  Network network{.transport = configured};
  if (const auto id = variable("ROS_DOMAIN_ID")) network.domain_id = parse_domain_id(*id);
  if (const auto range = variable("ROS_AUTOMATIC_DISCOVERY_RANGE")) {
    // An unknown value closes, as ROS 2 does.
    network.transport =
        (*range == "SUBNET" || *range == "SYSTEM_DEFAULT") ? Transport::lan : Transport::localhost;
  }
  if (variable("ROS_LOCALHOST_ONLY") == "1") network.transport = Transport::localhost;
  if (const auto peers = variable("ROS_STATIC_PEERS")) {
    std::istringstream stream(*peers);
    for (std::string peer; std::getline(stream, peer, ';');) {
      if (!peer.empty()) network.static_peers.push_back(peer);
    }
  }
  return network;
}

}  // namespace bw::dds
