#include "runtime/host/injected_fault.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "runtime/base/named_seed.hpp"
#include "runtime/graph/names.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw {
namespace {

/// What a kind says of itself, against nothing yet.
class KindSetup : public FaultSetup {
 public:
  void clock(std::function<Duration(Duration since)> error) override { clock_error = std::move(error); }
  void begins_and_ends(Step its_begin, Step its_end) override {
    begin = std::move(its_begin);
    end = std::move(its_end);
  }
  void acts(Step its_step) override { step = std::move(its_step); }
  void is_of_a_process(bool memory_limit) override {
    of_a_process = true;
    needs_memory_limit = memory_limit;
  }
  void changes_parameters_of_component() override { changes_parameters = true; }
  std::uint64_t seed() const override { return 1; }

  [[nodiscard]] bool is_of_component() const { return clock_error || begin || step || changes_parameters; }

  std::vector<Gate> gates;
  std::function<Duration(Duration since)> clock_error;
  Step begin, end, step;
  bool of_a_process = false, needs_memory_limit = false, changes_parameters = false;
  ParameterReport report;

 protected:
  void add_gate(Gate gate) override { gates.push_back(std::move(gate)); }
  const ConfigNode& section() const override {
    static const ConfigNode kNothing{};
    return kNothing;
  }
  std::string path() const override { return {}; }
  void keep_parameters(ParameterReport its_report) override { report = std::move(its_report); }
};

class GraphSetup final : public KindSetup {
 public:
  GraphSetup(const FaultSettings& settings, std::uint64_t run_seed)
      : settings_(settings), seed_(named_seed(settings.name, run_seed)) {}
  std::uint64_t seed() const override { return seed_; }

 protected:
  const ConfigNode& section() const override {
    static const ConfigNode kNothing{};
    return changes_parameters ? kNothing : settings_.parameters;
  }
  std::string path() const override { return "faults." + settings_.name + ".parameters"; }

 private:
  const FaultSettings& settings_;
  std::uint64_t seed_;
};

class Resolver {
 public:
  Resolver(const FaultSurroundings& around, InjectedFault& fault) : around_(around), fault_(fault) {}

  void resolve() {
    const FaultSettings& settings = fault_.settings;
    std::vector<std::string_view> known;
    const std::vector<FaultKind> kinds = registered_faults();
    for (const FaultKind& kind : kinds) known.push_back(kind.name);
    const auto kind = std::ranges::find(kinds, settings.kind, &FaultKind::name);
    if (kind == kinds.end())
      refuse("kind", settings.kind, unknown_rule("kind of fault", settings.kind, known));
    fault_.fault = kind->make();
    GraphSetup setup(settings, around_.seed);
    fault_.fault->configure(setup);
    if (setup.of_a_process && around_.is_lockstep)
      refuse("kind", settings.kind, "is of a process, which lock-step has not: `bandwagon launch`");
    find_components(setup);
    find_topics(setup);
    if (setup.changes_parameters) take_parameters(setup);
    if (!setup.changes_parameters && settings.parameters.is_map() && !settings.parameters.map.empty() &&
        setup.report.names.empty())
      refuse("parameters", "a map", "must not be given: this kind has none");
    fault_.clock_error = std::move(setup.clock_error);
    fault_.begin = std::move(setup.begin);
    fault_.end = std::move(setup.end);
    fault_.step = std::move(setup.step);
    fault_.is_of_a_process = setup.of_a_process;
  }

 private:
  [[noreturn]] void refuse(const std::string& key, const std::string& value, const std::string& rule) const {
    throw ConfigError(
        Violation{fault_.settings.where, "faults." + fault_.settings.name + "." + key, value, rule});
  }

  void find_components(const KindSetup& setup) {
    const std::string& of = fault_.settings.of;
    if (!setup.is_of_component()) {
      if (!of.empty()) refuse("of", of, "must not be given: this kind is of a topic");
      return;
    }
    if (of.empty()) refuse("of", "", "must name a component or a process");
    std::vector<std::string_view> known;
    for (Actor* actor : around_.actors) {
      if (actor->role != ActorRole::component) continue;
      known.push_back(actor->name);
      known.push_back(actor->process);
      if (actor->name == of || actor->process == of) fault_.of.push_back(actor);
    }
    if (fault_.of.empty()) refuse("of", of, unknown_rule("component or process", of, known));
    fault_.where = "of " + of;
    const std::string& process = fault_.of.front()->process;
    const auto limits = around_.graph->limits.find(process);
    if (setup.needs_memory_limit && (limits == around_.graph->limits.end() || !limits->second.memory))
      refuse("of", of, "needs a limit in the graph: processes: {" + process + ": {memory: 800MB}}");
  }

  void find_topics(KindSetup& setup) {
    const FaultSettings& settings = fault_.settings;
    if (!settings.topic.empty() && setup.gates.size() != 1)
      refuse("topic", settings.topic,
             setup.gates.empty() ? "must not be given: this kind is of no topic"
                                 : "must not be given: this kind is of several");
    for (auto& gate : setup.gates) {
      const std::string declared = settings.topic.empty() ? gate.topic : settings.topic;
      if (declared.empty()) refuse("topic", "", "must be given: this kind is of any");
      const std::string topic =
          resolve_name(join_namespaces(join_namespaces("", around_.graph->settings.graph_namespace),
                                       settings.node_namespace),
                       "faults", declared);
      check_type(topic, gate.type, gate.begins_with);
      fault_.where += (fault_.where.empty() ? "on " : ", ") + topic;
      fault_.gates.push_back({topic, std::move(gate.change), gate.always, gate.holds});
    }
  }

  void check_type(const std::string& topic, const MessageType* wanted, const std::string& begins_with) const {
    std::vector<std::string_view> known;
    bool is_there = false;
    for (const Actor* actor : around_.actors) {
      for (const auto& output : actor->outputs) {
        known.push_back(output->topic);
        if (output->topic != topic) continue;
        is_there = true;
        const std::string ros_name(output->type.ros_name);
        if (wanted != nullptr && wanted->ros_name != ros_name)
          refuse("topic", topic, "must carry " + std::string(wanted->ros_name) + ", and carries " + ros_name);
        const TypeDescription* type = find_type(ros_name);
        const bool begins = type != nullptr && !type->fields.empty() && type->fields[0].message != nullptr &&
                            type->fields[0].message->ros_name == begins_with;
        if (!begins_with.empty() && !begins)
          refuse("topic", topic,
                 "must carry a type that begins with " + begins_with + ", and carries " + ros_name);
      }
    }
    if (!is_there && around_.is_whole)
      refuse("topic", topic, "must be published in the graph: " + unknown_rule("topic", topic, known));
  }

  /// As YAML has it: a whole number is a double where the parameter is one.
  static std::optional<NamedValue> value_of(const ConfigEntry& entry,
                                            const LiveParameters::Parameter& parameter) {
    std::optional<ParameterValue> value = parameter_value_of(entry.value);
    if (!value) return std::nullopt;
    if (type_of(parameter.value) == ParameterType::floating_point &&
        type_of(*value) == ParameterType::integer)
      *value = static_cast<double>(std::get<std::int64_t>(*value));
    return NamedValue{entry.key, *value};
  }

  void take_parameters(KindSetup& setup) {
    Actor& actor = *fault_.of.front();
    if (fault_.of.size() > 1) refuse("of", fault_.settings.of, "must name a component: this kind is of one");
    LiveParameters tried = actor.live_parameters;
    tried.set_configured(false);
    std::vector<NamedValue> wanted, before;
    if (!fault_.settings.parameters.is_map())
      refuse("parameters", "", "must name parameters of " + actor.name);
    for (const ConfigEntry& entry : fault_.settings.parameters.map) {
      const std::string key = "parameters." + entry.key;
      const auto found = actor.live_parameters.find(entry.key);
      const std::vector<std::string> names = actor.live_parameters.names();
      if (!found)
        refuse(key, entry.value.text(),
               unknown_rule("parameter of " + actor.name, entry.key, {names.begin(), names.end()}));
      if (found->descriptor.read_only)
        refuse(key, entry.value.text(), "must be one that may change while " + actor.name + " is active");
      const auto value = value_of(entry, *found);
      if (!value) refuse(key, entry.value.text(), "must be a value");
      const auto outcome = tried.change_all({&*value, 1}, {});
      if (!outcome.refusals.front().empty()) refuse(key, entry.value.text(), outcome.refusals.front());
      wanted.push_back(*value);
      before.push_back({entry.key, found->value});
    }
    const auto change = [&actor](const std::vector<NamedValue>& values, const FaultTick& tick) {
      for (const std::string& why : actor.live_parameters.change_all(values, {.now = tick.now}).refusals) {
        if (!why.empty()) throw std::runtime_error(why);
      }
    };
    setup.begin = [wanted, change](const FaultTick& tick) { change(wanted, tick); };
    setup.end = [before, change](const FaultTick& tick) { change(before, tick); };
  }

  const FaultSurroundings& around_;
  InjectedFault& fault_;
};

}  // namespace

FaultTick InjectedFault::at(Time now, Time start) const {
  const Duration run = now - start;
  const auto occurrence = settings.occurrence_at(run);
  if (occurrence) return {now, true, *occurrence, run - settings.beginning_of(*occurrence)};
  if (run < settings.from) return {now, false, -1, Duration{}};
  const std::int64_t last =
      settings.every ? (run - settings.from).nanoseconds / settings.every->nanoseconds : 0;
  return {now, false, last, run - settings.beginning_of(last)};
}

std::vector<std::unique_ptr<InjectedFault>> injected_faults(const FaultSurroundings& around) {
  std::vector<std::unique_ptr<InjectedFault>> faults;
  const auto section = around.graph->shared.find("faults");
  if (section == around.graph->shared.end()) return faults;
  std::vector<Violation> violations;
  for (FaultSettings& settings : read_faults(section->second, violations)) {
    auto& fault = faults.emplace_back(std::make_unique<InjectedFault>());
    fault->settings = std::move(settings);
    try {
      Resolver(around, *fault).resolve();
    } catch (const ConfigError& error) {
      faults.pop_back();
      if (!around.is_whole) continue;  // what it is of is not run
      violations.insert(violations.end(), error.violations().begin(), error.violations().end());
    }
  }
  throw_if_any(std::move(violations));
  return faults;
}

FaultDescription describe(const FaultKind& kind) {
  const auto fault = kind.make();
  KindSetup setup;
  fault->configure(setup);
  FaultDescription description{.topics = {},
                               .is_of_component = setup.is_of_component(),
                               .is_of_a_process = setup.of_a_process,
                               .parameters = setup.report};
  for (const auto& gate : setup.gates) description.topics.push_back(gate.topic);
  return description;
}

}  // namespace bw
