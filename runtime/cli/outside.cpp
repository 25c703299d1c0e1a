#include "runtime/cli/outside.hpp"

#include <chrono>
#include <thread>

namespace bw::cli {

Outside::Outside()
    : participant_({.network = dds::Network::from_environment(dds::Transport::localhost)}),
      directory_(participant_) {}

void Outside::settle(const std::function<bool()>& found) {
  using namespace std::chrono_literals;
  const auto start = std::chrono::steady_clock::now();
  const auto earliest = start + 1300ms;  // one announcement period and a little
  auto last_change = start;
  for (std::size_t known = 0; std::chrono::steady_clock::now() < start + 3s;) {
    std::this_thread::sleep_for(50ms);
    const auto now = std::chrono::steady_clock::now();
    if (const std::size_t count = endpoints(true).size(); count != known) {
      known = count;
      last_change = now;
    }
    if (now > earliest && now - last_change > 500ms && (found ? found() : known > 0)) return;
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

const std::vector<ParticipantEntities>& Outside::nodes() {
  directory_.update();
  return directory_.participants();
}

std::string Outside::node_of(const dds::Guid& endpoint) {
  directory_.update();
  std::string name = directory_.node_of(endpoint);
  return name.empty() ? "_NODE_NAME_UNKNOWN_" : name;
}

}  // namespace bw::cli
