#include "tests/interop/nav2_tree/manager.hpp"

#include <ranges>

#include "tests/interop/eventually.hpp"

namespace nav2 {
namespace {

constexpr std::chrono::seconds kStartLimit{30};  // the original waits for ever, for a node and for a reply
constexpr std::chrono::seconds kServiceLimit{5};
constexpr std::chrono::milliseconds kStateLook{5};

// lifecycle_msgs/Transition and State
constexpr std::uint8_t kConfigure = 1, kCleanup = 2, kActivate = 3, kDeactivate = 4, kShutdown = 5;
constexpr std::uint8_t kUnconfigured = 1, kInactive = 2, kActive = 3, kFinalized = 4;

std::uint8_t state_after(std::uint8_t transition) {
  switch (transition) {
    case kConfigure:
    case kDeactivate:
      return kInactive;
    case kActivate:
      return kActive;
    case kCleanup:
      return kUnconfigured;
    default:
      return kFinalized;
  }
}

}  // namespace

Manager::Manager(plain::Node& node, const std::vector<std::string>& node_names) : bonds_(node) {
  for (const std::string& name : node_names) {
    const auto client = [&](const std::string& service, const std::string& type) {
      return std::make_unique<plain::Client>(node, "/" + name + "/" + service,
                                             plain::ServiceType{"lifecycle_msgs/srv/" + type, "", ""});
    };
    nodes_.push_back({.name = name,
                      .change_state = client("change_state", "ChangeState"),
                      .get_state = client("get_state", "GetState")});
  }
}

bool Manager::wait_until(std::chrono::milliseconds limit, const std::function<bool()>& seen) {
  return bw::test::poll_until(Clock::now() + limit, kStateLook, [&] {
    bonds_.poll();
    return seen();
  });
}

std::optional<Bytes> Manager::call(plain::Client& client, const Bytes& request) {
  if (!wait_until(kServiceLimit, [&] { return client.is_ready(); })) return std::nullopt;
  const std::int64_t asked = client.send(request);
  std::optional<Bytes> reply;
  // Who was killed answers nothing: their lease ends about when their bond does, and this may be between the
  // two.
  wait_until(kStartLimit, [&] {
    reply = client.take(asked);
    return reply.has_value() || !client.is_ready();
  });
  return reply;
}

// The word of change_state is not looked at: the state afterwards is.
bool Manager::change(Managed& node, std::uint8_t transition) {
  if (!call(*node.change_state, CdrOut().number(transition).text("").bytes())) return false;
  const auto state = call(*node.get_state, CdrOut().number(std::uint8_t{0}).bytes());
  if (!state || CdrIn(*state).number<std::uint8_t>() != state_after(transition)) return false;
  if (transition == kDeactivate) bonds_.end(node.name);
  if (transition != kActivate) return true;
  bonds_.start(node.name);
  return wait_until(kBondTimeout / 2, [&] { return bonds_.is_formed(node.name); });
}

std::optional<std::string> Manager::startup() {
  for (Managed& node : nodes_) {
    if (!wait_until(kStartLimit, [&] { return node.get_state->is_ready(); }))
      return node.name + " is not there";
  }
  for (const std::uint8_t transition : {kConfigure, kActivate}) {
    for (Managed& node : nodes_) {
      if (!change(node, transition))
        return node.name + (transition == kConfigure ? " cannot be configured" : " cannot be activated");
    }
  }
  return std::nullopt;
}

std::optional<std::string> Manager::watch(std::chrono::milliseconds duration) {
  std::optional<std::string> lost;
  wait_until(duration, [&] {
    for (const Managed& node : nodes_) {
      if (bonds_.is_broken(node.name)) lost = node.name;
    }
    return lost.has_value();
  });
  return lost;
}

// Goes on when a node fails; not when one is gone: the original's exception ends its loop.
void Manager::change_down(std::uint8_t transition) {
  for (Managed& node : std::views::reverse(nodes_)) {
    if (!change(node, transition) && !node.change_state->is_ready()) return;
  }
}

void Manager::reset() {
  change_down(kDeactivate);
  change_down(kCleanup);
  bonds_.forget();
}

void Manager::shutdown() {
  reset();
  change_down(kShutdown);
}

}  // namespace nav2
