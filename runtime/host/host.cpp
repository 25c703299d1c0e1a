#include "runtime/host/host.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "runtime/graph/names.hpp"
#include "runtime/host/command_guard.hpp"
#include "runtime/host/duplicate_name_guard.hpp"
#include "runtime/host/host_setup.hpp"
#include "runtime/host/injector.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/host/parameter_services.hpp"
#include "runtime/host/process_services.hpp"
#include "runtime/host/terminal.hpp"
#include "runtime/host/type_description_service.hpp"
#include "runtime/host/writer_clock.hpp"
#include "runtime/host/writer_names.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/registry.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/node_announcement.hpp"
#include "runtime/stamps.hpp"
#include "runtime/thrown.hpp"

namespace bw {
namespace {

std::unique_ptr<Component> make_or_refuse(const ComponentNode& node) {
  if (auto component = make_component(node.type)) return component;
  const std::vector<std::string> known = registered_components();
  const std::vector<std::string_view> views(known.begin(), known.end());
  throw ConfigError({.where = node.where,
                     .key = "components." + node.name + ".type",
                     .value = node.type,
                     .rule = unknown_rule("component", node.type, views)});
}

ComponentDeclaration declaration_of(const Actor& actor) {
  ComponentDeclaration d{.name = actor.name, .inputs = {}, .outputs = {}};
  for (const auto& input : actor.inputs) {
    if (!input->is_declared) continue;
    d.inputs.push_back({.name = input->name,
                        .type = std::string(input->type.ros_name),
                        .qos = input->qos,
                        .optional = input->need == Need::optional,
                        .only_newest = input->kind == InputKind::keep_newest});
  }
  for (const auto& output : actor.outputs) {
    if (output->of_node) continue;
    d.outputs.push_back({.name = output->name,
                         .type = std::string(output->type.ros_name),
                         .qos = output->qos,
                         .command = output->command});
  }
  for (const auto& service : actor.services)
    d.services.push_back({.name = service->name, .type = std::string(service->type.ros_name)});
  for (const auto& client : actor.clients) {
    d.clients.push_back({.name = client->name,
                         .type = std::string(client->type.ros_name),
                         .optional = client->need == Need::optional});
  }
  return d;
}

/// Of those that have bonds: who follows another has none of its own.
std::vector<std::string> bond_namespaces(const Graph& graph) {
  std::vector<std::string> names;
  for (const ComponentNode& node : graph.components) {
    if (node.follows.empty()) names.push_back(node.node_namespace);
  }
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  return names;
}

/// What every node of ROS 2 has.
struct NodeParameters {
  bool use_sim_time = false;

  template <class Visitor>
  void fields(Visitor& v) {
    v("use_sim_time", use_sim_time, {.doc = "time comes from /clock, as the command line says"});
  }
};

}  // namespace

Host::Host(Graph graph, HostOptions options, std::vector<ExtraComponent> extra)
    : graph_(std::move(graph)),
      options_(std::move(options)),
      writers_(std::make_unique<WriterNames>(actors_)) {
  std::erase_if(graph_.components, [](const ComponentNode& node) { return !node.enabled; });
  const std::vector<std::string> processes = graph_.processes();
  const std::string& only = options_.only_process;
  if (!only.empty() && std::ranges::find(processes, only) == processes.end()) {
    throw std::runtime_error("the graph has no process \"" + only +
                             "\"; it has: " + fmt::format("{}", fmt::join(processes, ", ")));
  }
  if (!only.empty() && options_.clock == ClockMode::lockstep) {
    throw std::runtime_error("lock-step runs the whole graph in one process: --only needs --clock wall");
  }
  for (const std::string& plugin : graph_.settings.plugins) load_plugin(plugin);
  for (ExtraComponent& e : extra) {
    graph_.components.insert(e.first ? graph_.components.begin() : graph_.components.end(),
                             {.name = e.name,
                              .type = e.name,
                              .process = only.empty() ? "main" : only,
                              .lane = e.lane,
                              .node_namespace = e.node_namespace});
  }

  const bool lockstep = options_.clock == ClockMode::lockstep;
  ProcessServiceOptions service_options{
      .publishes_clock = lockstep, .on_clock = nullptr, .look_around = nullptr, .timings = !lockstep};
  if (!lockstep) service_options.look_around = [this](Time now) { look_around(now); };
  if (options_.clock == ClockMode::topic) {
    auto topic_clock = std::make_unique<TopicClock>();
    service_options.on_clock = [clock = topic_clock.get()](Time now) { clock->set(now); };
    clock_ = std::move(topic_clock);
  } else {
    clock_ = std::make_unique<MonotonicClock>();
  }
  if (graph_.settings.external_lifecycle && lockstep && !options_.accept_inputs &&
      options_.source == nullptr && !options_.is_partial) {
    throw std::runtime_error(
        "lifecycle: external waits for a manager from outside, and a run in lock-step takes nothing from outside without "
        "--accept-inputs");
  }
  if (graph_.settings.external_lifecycle && !lockstep)
    service_options.bond_namespaces = bond_namespaces(graph_);
  auto services = std::make_unique<ProcessServices>(std::move(service_options), local_);
  services_ = services.get();
  add_component(node_of_process(only), std::move(services), true, ActorRole::process);
  std::vector<Violation> violations;
  for (const ComponentNode& node : graph_.components) {
    const auto own = std::ranges::find(extra, node.name, &ExtraComponent::name);
    try {
      add_component(node, own != extra.end() ? std::move(own->component) : make_or_refuse(node),
                    only.empty() || node.process == only,
                    own != extra.end() ? ActorRole::observer : ActorRole::component);
    } catch (const ConfigError& error) {
      for (const Violation& violation : error.violations()) violations.push_back(violation);
    } catch (const std::runtime_error& error) {
      violations.push_back({.where = node.where, .key = node.name, .value = {}, .rule = error.what()});
    }
  }
  throw_if_any(std::move(violations));
  if (!options_.is_partial) add_managers();
  if (lockstep) {
    outside_ = std::make_unique<OutsideInputs>(options_.accept_inputs, [](const std::string& text) {
      write_to_terminal(LogLevel::warn,
                        text);  // not on /rosout: a refused message changes nothing, no sample either
    });
    heard_outside_ = OutsideInputs::topics_of(actors_);
    if (options_.accept_inputs) {
      const ComponentNode& node = graph_.components.emplace_back(
          ComponentNode{.name = OutsideInputs::kNode, .type = OutsideInputs::kNode, .lane = "services"});
      add_component(node, outside_->make_component(heard_outside_), true, ActorRole::observer);
      outside_actor_ = actors_.back().get();
    }
  }
  add_faults();
  for (const auto& actor : actors_) {
    if (actor->is_in_graph()) declarations_.push_back(declaration_of(*actor));
  }
  if (!options_.is_partial) throw_if_any(check_graph(declarations_, graph_));
}

Host::~Host() {
  announcement_.reset();
  outside_.reset();
  for (const auto& actor : actors_) {
    actor->watched.clear();
    actor->inputs.clear();
    actor->outputs.clear();
    actor->actions.clear();
    actor->services.clear();
    actor->clients.clear();
  }
}

void Host::add_component(const ComponentNode& node, std::unique_ptr<Component> component, bool here,
                         ActorRole role) {
  auto actor = std::make_unique<Actor>();
  actor->role = role;
  actor->name = node.name;
  actor->node_name = node.node_name();
  actor->node_namespace = node.node_namespace;
  actor->type = node.type;
  actor->process = node.process;
  actor->lane = node.lane;
  actor->is_real_time = node.is_real_time;
  actor->rank = actors_.size();
  actor->latency = node.latency;
  actor->live_parameters = LiveParameters(node.name);
  actor->component = std::move(component);
  if (here) local_.push_back(actor.get());
  actors_.push_back(std::move(actor));
  Actor& added = *actors_.back();
  added.on_first_rejected = [this, &added](const Input& input) {
    log(added, LogLevel::warn,
        fmt::format("a sample on {} is no {} and was thrown away; /diagnostics counts them", input.topic,
                    input.type.ros_name));
  };
  HostSetup setup(*this, added, node);
  added.component->configure(setup);
  setup.declare_for_the_node();
  offer_lifecycle(added, setup);
  offer_parameters(setup, added);
  offer_type_descriptions(setup, added);
}

void Host::add_faults() {
  FaultSurroundings around{.graph = &graph_,
                           .actors = {},
                           .seed = options_.seed,
                           .is_lockstep = options_.clock == ClockMode::lockstep,
                           .is_whole = !options_.is_partial && options_.source == nullptr};
  for (const auto& actor : actors_) around.actors.push_back(actor.get());
  auto injector = std::make_unique<Injector>(around, local_, options_.only_process);
  if (injector->is_idle()) return;
  injector_ = injector.get();
  ComponentNode node = node_of_process(options_.only_process);
  node.name = "faults";
  node.lane = "faults";
  node.node = "faults_" + node.node;  // one in each process
  add_component(node, std::move(injector), true, ActorRole::process);
}

void Host::offer_parameters(Setup& setup, Actor& actor) {
  actor.live_parameters.declare_read_only("", ParameterSet(NodeParameters{options_.clock != ClockMode::wall}),
                                          "--clock decides it for the whole run");
  offer_parameter_services(setup, actor.live_parameters, actor.parameters.rows,
                           [this, &actor](const Tick& tick, const std::vector<NamedValue>& changed) {
                             if (actor.state == lifecycle::State::unconfigured)
                               actor.lifecycle->forget_parameters();
                             services_->tell_change(join_namespaces(actor.node_namespace, actor.node_name),
                                                    tick.now, changed);
                           });
}

RunEnd Host::run(std::optional<Duration> duration) {
  connect();
  started_ = runner_->now();
  if (injector_ != nullptr) injector_->begin(*runner_, *started_);
  for (const auto& output : actors_.front()->outputs)
    output->sink = runner_.get();  // /rosout, before anybody speaks
  for (const EarlyLine& line : early_log_) {
    if (std::ranges::find(local_, line.actor) != local_.end())
      publish_log(*line.actor, line.level, line.text);
  }
  announce_nodes();
  const std::vector<Actor*> order = bring_up_order();
  std::optional<RunEnd> failure = bring_up(order);
  if (const std::string before = ServiceManager::predecessor();
      !before.empty() && options_.clock != ClockMode::lockstep) {
    log(*local_.front(), LogLevel::warn, "started again; the process before it " + before);
    local_.front()->set_value("process before", before);
  }
  if (!failure) service_manager_.ready(fmt::format("{} nodes are up", order.size()));
  RunEnd end = failure ? *failure : runner_->run(duration);
  service_manager_.stopping(end.reason, !failure && !end.has_thrown);
  // A run in lock-step may be ended by a person, who is to decide nothing of its bytes.
  if (options_.clock != ClockMode::lockstep)
    log(*local_.front(), end.ok ? LogLevel::info : LogLevel::error, "the run ends: " + end.reason);
  if (options_.tap) options_.tap->run_is_over();
  bring_down(order, end);
  if (options_.clock != ClockMode::lockstep) leave();
  return end;
}

void Host::finish(RunEnd end, bool at_rest) {
  const std::lock_guard lock(end_mutex_);
  if (runner_) {
    runner_->finish(std::move(end), at_rest ? Duration{} : time_to_rest_);
  } else if (!early_end_) {
    early_end_ = std::move(end);
  }
}

void Host::log(const Actor& actor, LogLevel level, const std::string& text) {
  const Time now = started_ ? runner_->now() : Time{};
  const double seconds = started_ ? (now - *started_).to_seconds() : 0.0;
  write_to_terminal(level, fmt::format("{:8.3f} [{}] {}", seconds, actor.name, text));
  if (level >= LogLevel::warn) service_manager_.status(fmt::format("{}: {}", actor.name, text));
  if (started_) {
    publish_log(actor, level, text);
  } else {
    early_log_.push_back({&actor, level, text});
  }
}

/// Under the name that rclcpp gives the logger of a node: robot1.base for /robot1/base.
void Host::publish_log(const Actor& actor, LogLevel level, const std::string& text) {
  const std::string& node = actor.role == ActorRole::process ? actor.name : actor.node_name;
  std::string name = actor.node_namespace == "/" ? node : actor.node_namespace.substr(1) + "." + node;
  std::ranges::replace(name, '/', '.');
  // Whoever speaks goes on: it may be the end of the run that is told, and on a thread that is no lane.
  try {
    services_->log(name, runner_->now(), level, text);
  } catch (...) {
    write_to_terminal(LogLevel::error, "not on /rosout: " + thrown_text());
  }
}

std::vector<std::pair<std::string, ParameterReport>> Host::parameters() const {
  std::vector<std::pair<std::string, ParameterReport>> all;
  for (const auto& actor : actors_) {
    if (actor->is_in_graph()) all.emplace_back(actor->name, actor->parameters);
  }
  return all;
}

std::vector<std::pair<std::string, FailsafeRow>> Host::failsafes() const {
  std::vector<std::pair<std::string, FailsafeRow>> all;
  for (const auto& actor : actors_) {
    for (const Actor::DeclaredFailsafe& failsafe : actor->failsafes)
      all.emplace_back(actor->name, failsafe.row);
    for (const Input* input : actor->watched) {
      if (input->on_stale == OnStale::ignore) continue;
      const bool stops = input->on_stale == OnStale::stop;
      all.push_back({actor->name,
                     {.name = input->name,
                      .condition = input->topic + " is silent",
                      .debounce = *input->max_age,
                      .action = stops ? FailsafeAction::stop : FailsafeAction::slow,
                      .recovery = "by itself, with the next message"}});
    }
  }
  return all;
}

std::vector<std::pair<std::string, std::string>> Host::faults() const {
  return injector_ == nullptr ? std::vector<std::pair<std::string, std::string>>() : injector_->in_words();
}

std::map<std::string, ParameterReport> Host::shared_parameters() const {
  std::map<std::string, ParameterReport> all;
  for (const auto& actor : actors_)
    all.insert(actor->shared_parameters.begin(), actor->shared_parameters.end());
  return all;
}

std::vector<CallbackStatistics> Host::statistics() const {
  std::vector<CallbackStatistics> all;
  for (const Actor* actor : local_) {
    const std::lock_guard lock(actor->mutex);
    for (const auto& timer : actor->timers) all.push_back(timer->statistics);
    for (const auto& input : actor->inputs) all.push_back(input->statistics);
  }
  return all;
}

std::string Host::samples_sha256() const {
  const auto* lockstep = dynamic_cast<const LockstepRunner*>(runner_.get());
  return lockstep == nullptr ? "" : lockstep->samples_sha256();
}

double Host::elapsed_seconds() const { return started_ ? (runner_->now() - *started_).to_seconds() : 0.0; }

}  // namespace bw
