#include "runtime/host/bonds.hpp"

#include <algorithm>
#include <random>

#include "runtime/graph/names.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

constexpr int kFarewells = 5;

/// In the form of a UUID. Never in lock-step: there are no bonds there.
std::string new_instance() {
  std::random_device random;
  const auto part = [&random] { return random() & 0xffffU; };
  return fmt::format("{:04x}{:04x}-{:04x}-{:04x}-{:04x}-{:04x}{:04x}{:04x}", part(), part(), part(), part(),
                     part(), part(), part(), part());
}

}  // namespace

void Bonds::configure(Setup& setup, const std::vector<std::string>& namespaces) {
  constexpr int kWriterDepth = 5, kReaderDepth = 100;
  log_ = setup.log();
  for (const std::string& node_namespace : namespaces) {
    const std::string topic = resolve_name(node_namespace, "bond", "bond");
    outputs_[node_namespace] = setup.output<bond::msg::Status>(topic, Qos::standard(kWriterDepth));
    setup.input<bond::msg::Status>(
        topic, Qos::standard(kReaderDepth),
        [this, node_namespace](const bond::msg::Status& status, const Tick& tick) {
          hear(node_namespace, status, tick.now);
        },
        Need::optional);
  }
  setup.every(kPeriod, "bond", [this](const Tick& tick) { beat(tick.now); });
}

void Bonds::beat(Time now) {
  for (const Actor* actor : actors_) {
    if (actor->role == ActorRole::component && !actor->is_led) beat(*actor, now);
  }
}

void Bonds::beat(const Actor& actor, Time now) {
  const auto found = bonds_.find(&actor);
  if (!actor.is_active()) {
    if (found != bonds_.end()) part(actor, found->second, now);
    return;
  }
  const std::uint64_t activation = actor.activations;
  if (found == bonds_.end() || found->second.activation != activation) {
    bonds_[&actor] = {.activation = activation, .instance = new_instance(), .heard = now};
    say(actor, bonds_[&actor], true, now);
    return;
  }
  Bond& bond = found->second;
  if (bond.is_over) return;
  if (bond.is_formed && now - bond.heard > kTimeout) {
    // As Nav2's servers: who manages is not needed for driving.
    log_.warn("{}: its manager is gone, no heartbeat for {} s; it goes on", actor.name,
              kTimeout.to_seconds());
    bond.is_over = true;
    return;
  }
  say(actor, bond, true, now);
}

/// A farewell may be lost, so it is said several times.
void Bonds::part(const Actor& actor, Bond& bond, Time now) {
  if (!bond.is_over) bond.farewells = kFarewells;
  bond.is_over = true;
  if (bond.farewells == 0) return;
  --bond.farewells;
  say(actor, bond, false, now);
}

void Bonds::hear(const std::string& node_namespace, const bond::msg::Status& status, Time now) {
  const auto actor = std::ranges::find_if(actors_, [&](const Actor* a) {
    return a->node_name == status.id() && a->node_namespace == node_namespace;
  });
  if (actor == actors_.end()) return;
  const auto found = bonds_.find(*actor);
  if (found == bonds_.end() || found->second.is_over || status.instance_id() == found->second.instance)
    return;
  Bond& bond = found->second;
  bond.is_formed = true;
  bond.heard = now;
  if (status.active()) return;
  bond.is_over = true;
  say(**actor, bond, false, now);
}

void Bonds::say(const Actor& actor, const Bond& bond, bool is_active, Time now) {
  bond::msg::Status status;
  status.header().stamp(to_stamp(now));
  status.id(actor.node_name);
  status.instance_id(bond.instance);
  status.active(is_active);
  status.heartbeat_timeout(static_cast<float>(kTimeout.to_seconds()));
  status.heartbeat_period(static_cast<float>(kPeriod.to_seconds()));
  outputs_.at(actor.node_namespace).publish(status);
}

}  // namespace bw
