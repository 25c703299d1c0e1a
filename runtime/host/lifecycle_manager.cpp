#include "runtime/host/lifecycle_manager.hpp"

#include <utility>

#include <std_srvs/srv/trigger.hpp>

namespace bw {

using lifecycle::State;
using lifecycle_msgs::srv::ChangeState;
using std_srvs::srv::Trigger;

namespace {

template <class Response>
Response unsuccessful() {
  Response response;
  response.success(false);
  return response;
}

}  // namespace

LifecycleManager::LifecycleManager(std::vector<Node> nodes)
    : nodes_(std::move(nodes)), known_(nodes_.size(), State::active) {}

void LifecycleManager::configure(Setup& setup) {
  log_ = setup.log();
  for (const Node& node : nodes_)
    clients_.push_back(setup.client<ChangeState>(node.change_state, Need::optional));
  setup.service<Manage>(
      "~/manage_nodes",
      [this](const Manage::Request& request, const Reply<Manage>& reply, const Tick&) {
        begin(request.command(), reply);
      },
      [log = setup.log()](const std::string& reason) {
        log.warn("manage_nodes refused: {}", reason);
        return unsuccessful<Manage::Response>();
      });
  setup.service<Trigger>("~/is_active", [this](const Trigger::Request&, const Tick&) {
    auto response = unsuccessful<Trigger::Response>();
    const std::vector<State> now = states();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (now[i] == State::active) continue;
      response.message(nodes_[i].name + " is " + std::string(label(now[i])));
      return response;
    }
    response.success(true);
    return response;
  });
}

std::vector<State> LifecycleManager::states() const {
  std::vector<State> now = known_;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].actor != nullptr) now[i] = nodes_[i].actor->state;
  }
  return now;
}

void LifecycleManager::begin(std::uint8_t number, const Reply<Manage>& reply) {
  const std::optional<lifecycle::Command> command = lifecycle::command_of(number);
  if (bring_up_ || !command) {
    log_.warn("manage_nodes: {}",
              bring_up_ ? "another command is under way" : "there is no command " + std::to_string(number));
    reply(unsuccessful<Manage::Response>());
    return;
  }
  bring_up_.emplace(*command, states());
  reply_ = reply;
  step();
}

void LifecycleManager::step() {
  const std::optional<lifecycle::BringUp::Step> step = bring_up_->next();
  if (!step) {
    end();
    return;
  }
  ChangeState::Request request;
  request.transition().id(step->id);
  request.transition().label(std::string(step->transition));
  const auto on_response = [this, taken = *step](const ChangeState::Response* response, const Tick&) {
    const Node& node = nodes_[taken.node];
    const bool is_done = response != nullptr && response->success();
    const State now = node.actor != nullptr ? node.actor->state.load() : is_done ? taken.goal : taken.from;
    if (response == nullptr) log_.error("{} did not answer", node.name);
    known_[taken.node] = now;
    bring_up_->finished(now);
    this->step();
  };
  clients_[step->node].call(request, kLongestTransition, on_response);
}

void LifecycleManager::end() {
  Manage::Response response;
  response.success(!bring_up_->failure());
  if (const auto& failure = bring_up_->failure()) {
    log_.error("{} did not {}: it was {}", nodes_[failure->node].name, failure->transition,
               label(failure->from));
  }
  bring_up_.reset();
  reply_(response);
}

}  // namespace bw
