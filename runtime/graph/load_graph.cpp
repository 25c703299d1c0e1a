#include <algorithm>
#include <utility>

#include "runtime/graph/config_file.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/graph/graph_reading.hpp"
#include "runtime/graph/several_robots.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

constexpr Duration kMaxLatency = Duration::milliseconds(10'000);
constexpr Duration kMaxAge = Duration::milliseconds(3'600'000);
constexpr Duration kShortestAge = Duration::milliseconds(1);

class GraphReader {
 public:
  Graph read(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    graph_.path = path;
    const ConfigNode root = load_yaml(path);
    if (!root.is_map()) add(root.where, "", "", "must be a map with the key components");
    throw_if_any(violations_);
    read_top(root);
    apply(overrides);
    if (processes_) graph_.limits = read_process_limits(*processes_, graph_.processes(), violations_);
    check_followers();
    check_distro();
    throw_if_any(std::move(violations_));
    return std::move(graph_);
  }

 private:
  void add(const Location& where, const std::string& key, const std::string& value, const std::string& rule) {
    violations_.push_back({where, key, value, rule});
  }

  static std::optional<std::string> frame_prefix_rule(std::string_view prefix) {
    const std::string_view trimmed = prefix.ends_with('/') ? prefix.substr(0, prefix.size() - 1) : prefix;
    if (prefix.empty() || (!trimmed.starts_with('/') && !namespace_rule(trimmed))) return std::nullopt;
    return "must be a prefix of frame names, such as robot1_ or robot1/";
  }

  std::optional<Duration> read_duration(ParameterReader& reader, std::string_view name, Duration least,
                                        Duration most) {
    const ConfigNode* node = reader.find(name);
    if (node == nullptr) return std::nullopt;
    const std::optional<Duration> duration = node->is_scalar() ? parse_duration(node->scalar) : std::nullopt;
    if (!duration) {
      reader.refuse(*node, name, "must be a duration, such as 20ms, 0.5s or a number of seconds");
    } else if (*duration < least || *duration > most) {
      reader.refuse(*node, name,
                    "must be between " + short_text(least.to_seconds()) + " and " +
                        short_text(most.to_seconds()) + " s");
    } else {
      return duration;
    }
    return std::nullopt;
  }

  /// A section written in place or in a file of its own.
  ConfigNode read_section(ParameterReader& reader, const ConfigNode& node, std::string_view name) {
    if (node.is_map() || node.is_null()) return node;
    if (!node.is_scalar()) {
      reader.refuse(node, name, "must be a map or the path of a YAML file");
      return {};
    }
    try {
      ConfigNode section = load_yaml(resolve_path(node.where, node.scalar));
      if (section.is_map() || section.is_null()) return section;
      violations_.push_back(
          {section.where, std::string(name), section.text(), "must be a map of parameters"});
    } catch (const ConfigError& error) {
      for (const Violation& violation : error.violations()) {
        if (violation.where.line > 0) {
          violations_.push_back(violation);
        } else {
          reader.refuse(node, name, violation.text());
        }
      }
    }
    return {};
  }

  void read_top(const ConfigNode& root) {
    ParameterReader reader(root, "", violations_);
    GraphSettings& settings = graph_.settings;
    reader("ros_distro", settings.ros_distro);
    if (const ConfigNode* distro = reader.find("ros_distro")) distro_where_ = distro->where;
    read_name(reader, root, "namespace", settings.graph_namespace, namespace_rule);
    read_name(reader, root, "frame_prefix", settings.frame_prefix, frame_prefix_rule);
    reader("transport", settings.transport, {.choices = {"localhost", "lan"}});
    reader("plugins", settings.plugins, {.path = true});
    std::string lifecycle = "own";
    reader("lifecycle", lifecycle, {.choices = {"own", "external"}});
    settings.external_lifecycle = lifecycle == "external";
    if (distro_where_.file.empty()) {
      const ConfigNode* node = reader.find("lifecycle");
      distro_where_ = node != nullptr ? node->where : root.where;
    }
    bool emulate = false;
    reader("emulate", emulate);
    if (emulate) emulate_where_ = reader.find("emulate")->where;
    for (const std::string_view section : kSharedSections) {
      if (const ConfigNode* node = reader.find(section)) {
        graph_.shared[std::string(section)] = read_section(reader, *node, section);
      }
    }
    if (const ConfigNode* snapshot = reader.find("snapshot"))
      graph_.snapshot = read_snapshot(*snapshot, violations_);
    if (const ConfigNode* node = reader.find("tolerances"))
      graph_.tolerances = read_section(reader, *node, "tolerances");
    if (const ConfigNode* components = reader.find("components")) {
      if (components->is_map()) {
        for (const ConfigEntry& entry : components->map) read_component(entry);
      } else {
        reader.refuse(*components, "components", "must be a map of components");
      }
    } else {
      add(root.where, "components", "", "must be given");
    }
    give_to_robots(graph_, reader.find("robots"), shared_, violations_);
    if (const ConfigNode* names = reader.find("bring_up")) read_bring_up(*names);
    if (const ConfigNode* processes = reader.find("processes")) processes_ = *processes;
    reader.refuse_unknown_keys();
  }

  /// What waits for a manager from outside starts before the others, and would guess.
  void check_distro() {
    if (!graph_.settings.external_lifecycle || graph_.settings.ros_distro != RosDistro::automatic) return;
    add(distro_where_, "ros_distro", "auto",
        "must be named beside lifecycle: external: humble, jazzy, kilted or lyrical, as the manager's is; messages of "
        "nav2_msgs differ from each to the next");
  }

  void read_bring_up(const ConfigNode& names) {
    if (!is_list(names, "bring_up", violations_)) return;
    std::vector<std::string_view> known;
    for (const ComponentNode& node : graph_.components) known.push_back(node.name);
    for (const ConfigNode& name : names.sequence) {
      bool is_known = false;
      for (const ComponentNode& node : graph_.components) {
        if (!name.is_scalar() || !is_meant(node, name.scalar)) continue;
        is_known = true;
        if (std::ranges::find(graph_.bring_up, node.name) == graph_.bring_up.end()) {
          graph_.bring_up.push_back(node.name);
        } else {
          add(name.where, "bring_up", name.text(), "must be named once");
        }
      }
      if (!is_known) add(name.where, "bring_up", name.text(), unknown_rule("component", name.text(), known));
    }
  }

  /// Whose states are another's has no order, manager or process of its own.
  void check_followers() {
    std::vector<std::string_view> known;
    for (const ComponentNode& node : graph_.components) known.push_back(node.name);
    for (const ComponentNode& node : graph_.components) {
      if (node.follows.empty()) continue;
      const std::string key = joined(joined("components", node.name), "follows");
      const auto refuse = [&](const std::string& rule) { add(node.where, key, node.follows, rule); };
      const ComponentNode* leader = graph_.find(node.follows);
      if (leader == nullptr) {
        refuse(unknown_rule("component", node.follows, known));
      } else if (leader == &node || !leader->follows.empty()) {
        refuse("must be a component that follows none");
      } else if (leader->process != node.process) {
        refuse("must be in the same process");
      } else if (node.enabled && !leader->enabled) {
        refuse("must be enabled where its follower is");
      }
      if (std::ranges::find(graph_.bring_up, node.name) != graph_.bring_up.end())
        add(node.where, "bring_up", node.name, "must not name who follows: it comes up with its leader");
    }
  }

  void read_component(const ConfigEntry& entry) {
    ComponentNode node;
    node.name = node.type = entry.key;
    node.where = entry.where;
    const std::string key = joined("components", entry.key);
    if (const auto rule = node_name_rule(entry.key)) add(entry.where, key, "", *rule);
    if (is_shared_section(entry.key)) {
      add(entry.where, key, "", "must not be the name of a shared section");
    }
    if (!entry.value.is_map() && !entry.value.is_null()) {
      add(entry.value.where, key, entry.value.text(), "must be a map");
      return;
    }
    const ConfigNode& map = entry.value;
    ParameterReader reader(map, key, violations_);
    read_name(reader, map, "type", node.type, label_rule);
    read_name(reader, map, "process", node.process, label_rule);
    read_name(reader, map, "lane", node.lane, label_rule);
    std::string priority = "normal";
    reader("priority", priority, {.choices = {"normal", "real_time"}});
    node.is_real_time = priority == "real_time";
    reader("enabled", node.enabled);
    node.latency = read_duration(reader, "latency", Duration{}, kMaxLatency).value_or(Duration{});
    std::string manager = "navigation";
    reader("manager", manager, {.choices = {"navigation", "localization", "none"}});
    node.manager = manager == "none"           ? Manager::none
                   : manager == "localization" ? Manager::localization
                                               : Manager::navigation;
    read_name(reader, map, "follows", node.follows, node_name_rule);
    if (const ConfigNode* given = map.find("manager"); given != nullptr && !node.follows.empty())
      reader.refuse(*given, "manager", "must not be given beside follows: it is managed with its leader");
    std::string inner;
    read_name(reader, map, "namespace", inner, namespace_rule);
    node.node_namespace = join_namespaces(graph_.settings.graph_namespace, inner);
    bool is_shared = false;
    reader("shared", is_shared);
    if (is_shared) shared_.push_back(node.name);
    if (const ConfigNode* parameters = reader.find("parameters")) {
      node.parameters = read_section(reader, *parameters, "parameters");
    }
    if (node.parameters.where.file.empty()) node.parameters.where = entry.where;
    if (const ConfigNode* remap = reader.find("remap"))
      node.remaps = read_remaps(*remap, joined(key, "remap"), violations_);
    if (const ConfigNode* emulation = reader.find("emulation"))
      node.emulation = read_emulation(*emulation, joined(key, "emulation"), violations_);
    if (const ConfigNode* inputs = reader.find("inputs")) read_inputs(*inputs, joined(key, "inputs"), node);
    reader.refuse_unknown_keys();
    graph_.components.push_back(std::move(node));
  }

  void read_inputs(const ConfigNode& map, const std::string& key, ComponentNode& node) {
    if (!is_section(map, key, violations_)) return;
    for (const ConfigEntry& entry : map.map) {
      const std::string entry_key = joined(key, entry.key);
      if (!is_section(entry.value, entry_key, violations_)) continue;
      ParameterReader reader(entry.value, entry_key, violations_);
      InputSettings input;
      input.name = entry.key;
      input.where = entry.where;
      std::string on_stale = "stop";
      input.max_age = read_duration(reader, "max_age", kShortestAge, kMaxAge);
      reader("on_stale", on_stale, {.choices = {"stop", "degrade", "ignore"}});
      reader("external", input.external);
      input.on_stale = on_stale == "degrade"  ? OnStale::degrade
                       : on_stale == "ignore" ? OnStale::ignore
                                              : OnStale::stop;
      if (entry.value.find("on_stale") != nullptr && entry.value.find("max_age") == nullptr) {
        violations_.push_back(
            {entry.where, joined(entry_key, "on_stale"), on_stale, "needs a max_age beside it"});
      }
      reader.refuse_unknown_keys();
      node.inputs.push_back(std::move(input));
    }
  }

  /// What is emulated is up to the robot that is meant in the end, and gives way to what is said of single
  /// components.
  void apply(const std::vector<std::string>& overrides) {
    std::vector<Override> changes;
    for (const std::string& text : overrides) or_violation([&] { changes.push_back(parse_override(text)); });
    const auto of_sections = std::ranges::stable_partition(
        changes, [](const Override& c) { return is_shared_section(c.path.front()); });
    std::ranges::stable_partition(of_sections, is_emulate);
    auto change = changes.begin();
    for (; change != of_sections.begin(); ++change) or_violation([&] { apply_override(graph_, *change); });
    const bool is_said = change != changes.end() && is_emulate(*change);
    if (emulate_where_ && !is_said) or_violation([&] { emulate_devices(graph_, *emulate_where_); });
    for (; change != changes.end(); ++change) or_violation([&] { apply_override(graph_, *change); });
  }

  template <class Action>
  void or_violation(Action action) {
    try {
      action();
    } catch (const ConfigError& error) {
      violations_.insert(violations_.end(), error.violations().begin(), error.violations().end());
    }
  }

  Graph graph_;
  std::vector<std::string> shared_;      ///< components of which there is one for all robots
  std::optional<ConfigNode> processes_;  ///< which there are is known in the end
  std::vector<Violation> violations_;
  Location distro_where_;                  ///< where it is said, or ought to be
  std::optional<Location> emulate_where_;  ///< where the graph asks for it
};

}  // namespace

Graph load_graph(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return GraphReader().read(config_file("graphs", path), overrides);
}

}  // namespace bw
