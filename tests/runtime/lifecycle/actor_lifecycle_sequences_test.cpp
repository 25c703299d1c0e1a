// Every sequence of transitions of a component whose own work fails where it may, without a host and without
// DDS. Whatever fails, no exception comes out, a component that is not active is mute and does not tick, its
// calls come in their order, and why it is not where it was asked to be is said.
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/host/actor.hpp"
#include "runtime/host/runner.hpp"
#include "tests/exhaustive_sequences.hpp"

namespace bw {
namespace {

using lifecycle::State;

/// Counts what is sent, and keeps no time.
class StillRunner final : public Runner {
 public:
  Time now() const override { return Time::seconds(100.0); }
  void arrived(InputEndpoint&) override {}
  void schedule(Timer& timer, Time at) override { timer.next = at; }
  RunEnd run(std::optional<Duration>) override { return {}; }
  void finish(RunEnd, Duration) override {}
  void publish(OutputEnd&, std::span<const std::uint8_t>) override { ++sent; }
  void when_done(std::function<void()> action) override { action(); }
  int sent = 0;
};

enum class Work { configure, activate, deactivate, cleanup };

struct Managed {
  Managed() {
    actor.name = "it";
    actor.outputs.push_back(std::make_unique<OutputEnd>(actor, "/out", MessageType{}, Qos{}, true));
    actor.timers.push_back(std::make_unique<Timer>());
    actor.timers.back()->actor = &actor;
    actor.timers.back()->period = Duration::milliseconds(10);
    actor.lifecycle = std::make_unique<ActorLifecycle>(
        actor, LifecycleMeans{.make = [this] { return std::make_unique<Fragile>(*this); },
                              .configure = [this](Component& component) { configure(component); },
                              .tell = [this](const auto& transition, Time) { told = transition.goal; },
                              .log_error = [this](const std::string& text) { said = text; }});
    actor.lifecycle->connect(runner);
    actor.lifecycle->set_running(true);
    actor.state = State::unconfigured;
  }

  class Fragile final : public Component {
   public:
    explicit Fragile(Managed& managed) : managed_(managed) {}
    void configure(Setup&) override {}
    void activate(const Tick&) override {
      managed_.out().publish({});
      managed_.work(Work::activate);
      managed_.is_up = true;
    }
    void deactivate(const Tick&) override {
      if (!managed_.is_up) managed_.violation = "deactivated, and was not active";
      managed_.is_up = false;
      managed_.work(Work::deactivate);
      managed_.out().publish({});
    }
    void cleanup() override { managed_.work(Work::cleanup); }

   private:
    Managed& managed_;
  };

  OutputEnd& out() { return *actor.outputs.front(); }
  void configure(Component&) {
    work(Work::configure);
    actor.timers.front()->handler = [this](const Tick&) { ++ticks; };
  }
  void work(Work now) {
    if (fails == now) throw std::runtime_error("so it is");
  }

  void ask(const std::string& label) {
    const lifecycle::Transition* transition = lifecycle::requested_transition(actor.state, 0, label);
    if (transition == nullptr) return;  // refused by the service
    said.clear();
    const State goal = finishing_transition(transition->goal, lifecycle::Outcome::success).goal;
    const std::string reason = actor.lifecycle->change(*transition, runner.now());
    if (reason.empty() && actor.state != goal) violation = "it says that it is where it is not";
    if (!reason.empty() && said.empty()) violation = "no reason is said";
    if (told != actor.state) violation = "the state is not told";
    judge();
  }

  void judge() {
    const State state = actor.state;
    const bool is_active = state == State::active;
    if (state != State::unconfigured && state != State::inactive && !is_active && state != State::finalized)
      violation = "it stays on the way";
    const bool is_there = actor.component != nullptr;
    if (is_there != (is_active || state == State::inactive)) violation = "an instance too many, or none";
    if (is_active != (out().sink != nullptr))
      violation = "what is not active speaks, or what is active is mute";
    Timer& timer = *actor.timers.front();
    if (is_active != (timer.next != Timer::kNever))
      violation = "what is not active ticks, or what is active does not";
    const int before = ticks, sent = runner.sent;
    actor.fire(timer, runner.now(), std::nullopt);
    if (is_active != (ticks > before)) violation = "a tick of what is not active, or none of what is";
    out().publish({});
    if (is_active != (runner.sent > sent)) violation = "a word of what is not active, or none of what is";
    if (is_up && !is_active && fails != Work::activate) violation = "it was never deactivated";
  }

  StillRunner runner;
  Actor actor;
  std::optional<Work> fails;
  bool is_up = false;  ///< activated, and not deactivated since
  int ticks = 0;
  State told = State::unknown;
  std::string said;
  std::string violation;
};

TEST(ActorLifecycle, NothingThatFailsLeavesItHalfUpInEverySequence) {
  const auto ask = [](const char* label) { return [=](Managed& m) { m.ask(label); }; };
  const auto fails = [](std::optional<Work> work) { return [=](Managed& m) { m.fails = work; }; };
  const test::Sequences<Managed> sequences{
      .make = [] { return std::make_unique<Managed>(); },
      .events = {{"configure", ask("configure")},
                 {"activate", ask("activate")},
                 {"deactivate", ask("deactivate")},
                 {"cleanup", ask("cleanup")},
                 {"shutdown", ask("shutdown")},
                 {"configure fails", fails(Work::configure)},
                 {"activate fails", fails(Work::activate)},
                 {"deactivate fails", fails(Work::deactivate)},
                 {"cleanup fails", fails(Work::cleanup)},
                 {"nothing fails", fails(std::nullopt)}},
      .broken = [](const Managed& managed) { return managed.violation; },
      .state =
          [](const Managed& m) {
            return std::to_string(static_cast<int>(m.actor.state.load())) + (m.is_up ? '+' : '-') +
                   (m.fails ? std::to_string(static_cast<int>(*m.fails)) : "");
          }};
  test::expect_unbroken("actor_lifecycle", sequences, test::sequence_depth(12));
}

}  // namespace
}  // namespace bw
