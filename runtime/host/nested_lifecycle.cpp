#include "runtime/host/nested_lifecycle.hpp"

#include <algorithm>
#include <utility>

#include "runtime/host/actor.hpp"

namespace bw {

using lifecycle::BringUp;
using lifecycle::Command;
using lifecycle::State;
using lifecycle_msgs::srv::ChangeState;
namespace id = lifecycle::transition_id;

namespace {

Command command_for(std::uint8_t transition) {
  switch (transition) {
    case id::kConfigure:
      return Command::configure;
    case id::kActivate:
      return Command::resume;
    case id::kDeactivate:
      return Command::pause;
    case id::kCleanup:
      return Command::cleanup;
    default:
      return Command::shutdown;
  }
}

}  // namespace

void NestedLifecycle::configure(Setup& setup) {
  log_ = setup.log();
  for (const Follower& follower : followers_)
    clients_.push_back(setup.client<ChangeState>(follower.change_state, Need::optional));
}

std::vector<State> NestedLifecycle::states() const {
  std::vector<State> now;
  for (const Follower& follower : followers_) now.push_back(follower.state());
  now.push_back(leader_.state);
  return now;
}

void NestedLifecycle::change(const lifecycle::Transition& transition, Time now, OnDone on_done) {
  if (bring_up_) {
    log_.warn("no {} while another transition is under way", transition.label);
    on_done(false);
    return;
  }
  on_done_ = std::move(on_done);
  failed_ = false;
  bring_up_.emplace(command_for(transition.id), states());
  step(now);
}

void NestedLifecycle::step(Time now) {
  const std::optional<BringUp::Step> step = bring_up_->next();
  if (!step) return end(now);
  if (step->node == followers_.size()) {
    leader_.lifecycle->change(*lifecycle::requested_transition(leader_.state, step->id, step->transition),
                              now);
    bring_up_->finished(leader_.state);
    return this->step(now);
  }
  ChangeState::Request request;
  request.transition().id(step->id);
  request.transition().label(std::string(step->transition));
  clients_[step->node].call(
      request, kLongestTransition,
      [this, node = step->node](const ChangeState::Response* response, const Tick& tick) {
        if (response == nullptr) log_.error("{} did not answer", followers_[node].name);
        bring_up_->finished(followers_[node].state());
        this->step(tick.now);
      });
}

/// A follower is up whose leader is not even configured.
bool NestedLifecycle::is_behind() const {
  return leader_.state == State::unconfigured &&
         std::ranges::any_of(followers_, [](const Follower& f) { return f.state() == State::inactive; });
}

void NestedLifecycle::end(Time now) {
  if (const auto& failure = bring_up_->failure()) {
    const bool own = failure->node == followers_.size();
    log_.error("{} did not {}: it was {}", own ? leader_.name : followers_[failure->node].name,
               failure->transition, label(failure->from));
    const bool is_first = !std::exchange(failed_, true);
    if (is_first && is_behind()) {
      bring_up_.emplace(Command::cleanup, states());
      return step(now);
    }
  }
  bring_up_.reset();
  std::exchange(on_done_, nullptr)(!failed_);
}

}  // namespace bw
