// How a host brings its components up and down: in the order of the graph, as far as they go, and never half.
#include <algorithm>
#include <exception>

#include "runtime/host/duplicate_name_guard.hpp"
#include "runtime/host/host.hpp"
#include "runtime/host/host_setup.hpp"
#include "runtime/host/lifecycle_manager.hpp"
#include "runtime/host/lifecycle_services.hpp"
#include "runtime/host/nested_lifecycle.hpp"
#include "runtime/host/rebinding.hpp"
#include "runtime/registry.hpp"

namespace bw {
namespace {

using lifecycle::State;

/// The transition of the table; the host asks only for those that are there.
const lifecycle::Transition& transition(State from, std::string_view label) {
  return *lifecycle::requested_transition(from, 0, label);
}

constexpr std::string_view manager_name(Manager manager) {
  return manager == Manager::localization ? "lifecycle_manager_localization" : "lifecycle_manager_navigation";
}

}  // namespace

void Host::offer_lifecycle(Actor& actor, HostSetup& setup) {
  LifecycleMeans means;
  means.log_error = [this, &actor](const std::string& text) { log(actor, LogLevel::error, text); };
  if (actor.role == ActorRole::component) {
    actor.is_led = !graph_.find(actor.name)->follows.empty();
    actor.led = led_by(actor);
    if (actor.led) actor.led->configure(setup);
    offer_lifecycle_services(setup, actor);
    means.tell = offer_transition_events(setup);
    means.rivals = [this, &actor] {
      const std::string name = full_name({.node_namespace = actor.node_namespace, .name = actor.node_name});
      return duplicate_names_ ? duplicate_names_->rivals_of(name) : std::string();
    };
    means.make = [&actor] { return make_component(actor.type); };
    means.configure = [this, &actor](Component& component) {
      Rebinding rebinding(actor);
      ComponentNode& node = *std::ranges::find(graph_.components, actor.name, &ComponentNode::name);
      actor.live_parameters.write_changes(node.parameters);
      HostSetup again(*this, actor, node, &rebinding);
      component.configure(again);
      rebinding.commit();
    };
  }
  actor.lifecycle = std::make_unique<ActorLifecycle>(actor, std::move(means));
}

std::unique_ptr<NestedLifecycle> Host::led_by(Actor& leader) const {
  std::vector<NestedLifecycle::Follower> followers;
  for (const ComponentNode* node : graph_.followers_of(leader.name)) {
    followers.push_back({.name = node->name,
                         .change_state = node->topic_of("~/change_state"),
                         .state = [this, name = node->name] {
                           const auto actor = std::ranges::find(actors_, name, &Actor::name);
                           return actor == actors_.end() ? State::unknown : (*actor)->state.load();
                         }});
  }
  if (followers.empty()) return nullptr;
  return std::make_unique<NestedLifecycle>(leader, std::move(followers));
}

void Host::add_managers() {
  if (graph_.settings.external_lifecycle) return;
  // A pair for each robot, and one for what they share.
  std::vector<std::string> robots = graph_.robots;
  robots.insert(robots.begin(), "");
  for (const std::string& robot : robots) {
    add_manager(robot, Manager::localization);
    add_manager(robot, Manager::navigation);
  }
}

void Host::add_manager(const std::string& robot, Manager which) {
  std::vector<LifecycleManager::Node> nodes;
  std::string process;
  for (const ComponentNode* node : graph_.bring_up_order()) {
    const auto actor = std::ranges::find(actors_, node->name, &Actor::name);
    if (!node->follows.empty()) continue;  // its leader takes it along
    if (node->robot != robot || node->manager != which || actor == actors_.end() ||
        (*actor)->role != ActorRole::component)
      continue;
    const bool is_here = std::ranges::find(local_, actor->get()) != local_.end();
    nodes.push_back({.name = node->name,
                     .change_state = node->topic_of("~/change_state"),
                     .actor = is_here ? actor->get() : nullptr});
    process = node->process;
  }
  // One manager for all processes: in that of the last component to come up.
  if (nodes.empty() || (!options_.only_process.empty() && process != options_.only_process)) return;
  const std::string name(manager_name(which));
  const ComponentNode node{
      .name = robot.empty() ? name : robot + "/" + name,
      .process = process,
      .lane = "services",
      .node_namespace = join_namespaces(join_namespaces("", graph_.settings.graph_namespace), robot)};
  add_component(node, std::make_unique<LifecycleManager>(std::move(nodes)), true, ActorRole::manager);
}

std::vector<Actor*> Host::bring_up_order() const {
  std::vector<Actor*> managed;
  for (const ComponentNode* node : graph_.bring_up_order()) {
    const auto actor = std::ranges::find(local_, node->name, [](const Actor* a) { return a->name; });
    if (actor != local_.end() && (*actor)->role == ActorRole::component) managed.push_back(*actor);
  }
  std::vector<Actor*> order = local_;
  std::size_t next = 0;
  for (Actor*& actor : order) {
    if (actor->role == ActorRole::component) actor = managed[next++];
  }
  return order;
}

std::optional<RunEnd> Host::bring_up(const std::vector<Actor*>& order) {
  for (Actor* actor : order) {
    actor->lifecycle->connect(*runner_);
    for (const auto& output : actor->outputs) {
      if (output->of_node) output->sink = runner_.get();
    }
  }
  for (Actor* actor : order) {
    if (actor->role == ActorRole::component && graph_.settings.external_lifecycle) {
      actor->lifecycle->wait_for_configure();
      continue;
    }
    const std::string reason =
        actor->lifecycle->change(transition(State::inactive, "activate"), runner_->now());
    if (!reason.empty())
      return RunEnd{.ok = false, .reason = actor->name + " cannot be activated: " + reason};
  }
  for (Actor* actor : order) actor->lifecycle->set_running(true);
  return std::nullopt;
}

void Host::end_by(const CallbackFailure& failure) {
  Actor& actor = failure.actor;
  const std::string reason = actor.name + " failed in " + failure.callback + ": " + failure.what;
  runner_->finish({.ok = false, .reason = reason, .has_thrown = true}, time_to_rest_);
  if (failure.is_on_lane && actor.role != ActorRole::process && actor.is_active())
    static_cast<void>(actor.lifecycle->change(transition(State::active, "deactivate"), runner_->now()));
  log(actor, LogLevel::error, failure.callback + " threw: " + failure.what);
}

void Host::bring_down(const std::vector<Actor*>& order, RunEnd& end) {
  for (Actor* actor : order) actor->lifecycle->set_running(false);
  const auto take = [&](Actor& actor, State from, std::string_view label) {
    if (actor.state != from) return;
    const std::string reason = actor.lifecycle->change(transition(from, label), runner_->now());
    if (!reason.empty() && end.ok)
      end = {.ok = false, .reason = actor.name + " failed at the end: " + reason};
  };
  const std::vector<Actor*> backwards(order.rbegin(), order.rend());
  for (Actor* actor : backwards) take(*actor, State::active, "deactivate");
  for (Actor* actor : backwards) take(*actor, State::inactive, "cleanup");
}

}  // namespace bw
