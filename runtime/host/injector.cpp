#include "runtime/host/injector.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/host/runner.hpp"
#include "runtime/host/service_manager.hpp"
#include "runtime/ros/diagnostic_value.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

constexpr Duration kStep = Duration::milliseconds(10);

/// What a program adds to a graph is left alone: a replay says what became of a message once already.
bool may_fail(const Actor& actor) { return actor.role != ActorRole::observer; }

bool is_here(const InjectedFault& fault, const std::vector<Actor*>& local) {
  const auto publishes = [&](const Actor* actor) {
    return may_fail(*actor) && std::ranges::any_of(actor->outputs, [&](const auto& output) {
             return std::ranges::any_of(fault.gates,
                                        [&](const auto& gate) { return gate.topic == output->topic; });
           });
  };
  const auto is_local = [&](const Actor* actor) { return std::ranges::find(local, actor) != local.end(); };
  return std::ranges::any_of(fault.of, is_local) || std::ranges::any_of(local, publishes);
}

}  // namespace

Injector::Injector(const FaultSurroundings& around, const std::vector<Actor*>& local, std::string process)
    : faults_(injected_faults(around)),
      local_(local),
      process_(std::move(process)),
      is_lockstep_(around.is_lockstep) {
  std::erase_if(faults_, [&](const auto& fault) { return !is_here(*fault, local_); });
  for (const auto& fault : faults_) {
    place_gates(*fault);
    if (fault->begin) place_edges(*fault);
    if (!fault->clock_error) continue;
    for (Actor* actor : fault->of) {
      actor->clock_error = [this, before = actor->clock_error, its = fault.get()](Time now) {
        const FaultTick tick = its->at(now, start_);
        const Duration others = before ? before(now) : Duration{};
        return tick.acts ? others + its->clock_error(tick.since) : others;
      };
    }
  }
}

void Injector::place_gates(InjectedFault& fault) {
  for (InjectedFault::Gate& gate : fault.gates) {
    for (Actor* actor : local_) {
      for (const auto& output : actor->outputs) {
        if (output->topic != gate.topic || !may_fail(*actor)) continue;
        output->gate = this;
        gates_[output.get()].emplace_back(&fault, &gate);
      }
    }
  }
}

void Injector::place_edges(InjectedFault& fault) {
  Actor& actor = *fault.of.front();
  auto& edges = *edges_.emplace_back(std::make_unique<Edges>());
  auto timer = std::make_unique<Timer>();
  edges.fault = &fault;
  edges.timer = timer.get();
  timer->actor = &actor;
  timer->name = "fault " + fault.settings.name;
  timer->of_node = true;
  timer->handler = [this, &edges](const Tick& tick) { cross(edges, tick.now); };
  timer->statistics.component = actor.name;
  timer->statistics.callback = timer->name;
  actor.timers.push_back(std::move(timer));
}

std::vector<std::pair<std::string, std::string>> Injector::in_words() const {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& fault : faults_) {
    const FaultSettings& its = fault->settings;
    std::string text = fmt::format("{} {}, from {:g} s", its.kind, fault->where, its.from.to_seconds());
    text += its.lasts ? fmt::format(" for {:g} s", its.lasts->to_seconds()) : " to the end";
    if (its.every) text += fmt::format(", every {:g} s", its.every->to_seconds());
    all.emplace_back(its.name, std::move(text));
  }
  return all;
}

void Injector::configure(Setup& setup) {
  diagnostics_ = &setup.diagnostics();
  log_ = setup.log();
  out_ = setup.output<diagnostic_msgs::msg::DiagnosticArray>("/faults", Qos::standard(100));
  setup.every(kStep, "faults", [this](const Tick& tick) { step(tick.now); });
}

void Injector::begin(Runner& runner, Time start) {
  runner_ = &runner;
  began_ = start;
  start_ = is_lockstep_ ? start : start - ServiceManager::since_launch().value_or(Duration{});
  std::vector<std::string_view> names;
  for (const auto& fault : faults_) {
    if (fault->is_of_a_process && !ServiceManager::is_launched())
      throw ConfigError(Violation{fault->settings.where, "faults." + fault->settings.name + ".kind",
                                  fault->settings.kind,
                                  "needs `bandwagon launch`: nobody else would start the process again"});
    diagnostics_->set_value(fault->settings.name, fault->settings.kind + " " + fault->where + ": to come");
    names.push_back(fault->settings.name);
  }
  if (!names.empty())
    log_.warn("the graph makes things fail on purpose (faults: {}): not for a robot among people",
              fmt::join(names, ", "));
  for (const auto& edges : edges_) {
    const FaultSettings& its = edges->fault->settings;
    // What began before this process did is over for it.
    const Duration before = began_ - start_ - its.from;
    if (before > Duration{} && !its.every) continue;
    if (before > Duration{}) edges->occurrence = before.nanoseconds / its.every->nanoseconds + 1;
    plan(*edges);
  }
}

void Injector::plan(const Edges& edges) {
  const FaultSettings& its = edges.fault->settings;
  const Duration begins = its.beginning_of(edges.occurrence);
  runner_->schedule(*edges.timer, start_ + (edges.is_begun ? begins + *its.lasts : begins));
}

void Injector::cross(Edges& edges, Time now) {
  const FaultTick tick = edges.fault->at(now, start_);
  edges.is_begun = !edges.is_begun;
  if (edges.is_begun) {
    {
      const std::lock_guard lock(mutex_);
      tell(*edges.fault, tick);
    }
    if (edges.fault->settings.lasts) plan(edges);
    edges.fault->begin(tick);
    return;
  }
  edges.fault->end(tick);
  ++edges.occurrence;
  if (edges.fault->settings.every) plan(edges);
}

void Injector::pass(OutputEnd& output, std::span<const std::uint8_t> cdr) {
  if (const auto bytes = changed(output, cdr)) output.sink->publish(output, *bytes);
}

std::optional<std::vector<std::uint8_t>> Injector::changed(OutputEnd& output,
                                                           std::span<const std::uint8_t> cdr) {
  std::vector<std::uint8_t> bytes(cdr.begin(), cdr.end());
  const std::lock_guard lock(mutex_);
  const Time now = runner_->now();
  Duration held;
  for (const auto& [fault, gate] : gates_.at(&output)) {
    if (gate->holds) last_[&output].assign(cdr.begin(), cdr.end());
    const FaultTick tick = fault->at(now, start_);
    if (!tick.acts && !gate->always) continue;
    const Passage passage = gate->change(bytes, tick);
    if (passage.is_lost) return std::nullopt;
    held = held + passage.held;
  }
  if (held == Duration{}) return bytes;
  held_.push_back({now + held, sequence_++, &output, std::move(bytes)});
  return std::nullopt;
}

void Injector::step(Time now) {
  {
    const std::lock_guard lock(mutex_);
    std::string acting;
    for (const auto& fault : faults_) {
      const FaultTick tick = fault->at(now, start_);
      tell(*fault, tick);
      if (!tick.acts) continue;
      acting += (acting.empty() ? "" : ", ") + fault->settings.name;
      const bool is_ours = start_ + fault->settings.beginning_of(tick.occurrence) >= began_;
      if (fault->step && is_ours) fault->step(tick);
    }
    diagnostics_->report(acting.empty() ? DiagnosticReporter::Level::ok : DiagnosticReporter::Level::warn,
                         acting.empty() ? "no fault acts" : "on purpose: " + acting);
    release(now);
  }
  say_again(now);
}

void Injector::say_again(Time now) {
  std::vector<std::pair<OutputEnd*, std::vector<std::uint8_t>>> again;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [output, cdr] : last_) {
      const bool acts = std::ranges::any_of(gates_.at(output), [&](const auto& one) {
        return one.second->holds && one.first->at(now, start_).acts;
      });
      bool& did = said_again_[output];
      if (acts || did) again.emplace_back(output, cdr);
      did = acts;
    }
  }
  for (const auto& [output, cdr] : again) {
    const auto bytes = changed(*output, cdr);
    if (bytes && output->owner.is_active()) runner_->publish(*output, *bytes);
  }
}

void Injector::release(Time now) {
  const auto waits = std::ranges::stable_partition(held_, [&](const Held& one) { return one.due <= now; });
  std::vector<Held> due(std::make_move_iterator(held_.begin()), std::make_move_iterator(waits.begin()));
  held_.erase(held_.begin(), waits.begin());
  std::ranges::stable_sort(due, {}, [](const Held& one) { return std::pair(one.due, one.sequence); });
  for (const Held& one : due) {
    if (one.output->owner.is_active()) runner_->publish(*one.output, one.cdr);
  }
}

void Injector::tell(const InjectedFault& fault, const FaultTick& tick) {
  const FaultSettings& its = fault.settings;
  const std::pair state(tick.acts ? tick.occurrence : -1, tick.acts);
  const auto [before, is_first] = told_.try_emplace(&fault, std::pair<std::int64_t, bool>(-1, false));
  if (before->second == state) return;
  before->second = state;
  const std::string what = its.kind + " " + fault.where;
  diagnostic_msgs::msg::DiagnosticArray message;
  message.header().stamp(to_stamp(tick.now));
  diagnostic_msgs::msg::DiagnosticStatus status;
  status.level(
      static_cast<std::uint8_t>(tick.acts ? DiagnosticReporter::Level::warn : DiagnosticReporter::Level::ok));
  status.name(its.name);
  status.message(what + (tick.acts ? "" : ": over"));
  add_value(status, "kind", its.kind);
  add_value(status, "acts", tick.acts ? "true" : "false");
  add_value(status, "occurrence", std::to_string(tick.occurrence));
  add_value(status, "process", process_);
  add_value(status, "run time", fmt::format("{:.3f} s", (tick.now - start_).to_seconds()));
  message.status().push_back(std::move(status));
  out_.publish(message);
  diagnostics_->set_value(its.name, what + (tick.acts ? ": acts" : ": over"));
}

}  // namespace bw
