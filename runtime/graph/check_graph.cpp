#include "runtime/graph/check_graph.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "runtime/parameters/field_types.hpp"
#include "runtime/parameters/nearest.hpp"

namespace bw {
namespace {

template <class Declaration>
struct End {
  const ComponentNode* node;
  const Declaration* declared;

  std::string key() const { return joined(node->name, declared->name); }
  /// "motor_control (hallway.yaml:12)"
  std::string owner() const { return node->name + " (" + node->where.text() + ")"; }
};

struct Service {
  std::vector<End<ServiceDeclaration>> servers;
  std::vector<End<ClientDeclaration>> clients;
};

struct Topic {
  std::vector<End<OutputDeclaration>> writers;
  std::vector<End<InputDeclaration>> readers;
};

std::string reliability_text(const Qos& qos) {
  return qos.reliability == Reliability::reliable ? "reliable" : "best effort";
}

std::string durability_text(const Qos& qos) {
  return qos.durability == Durability::transient_local ? "transient local" : "volatile";
}

class Checker {
 public:
  Checker(const std::vector<ComponentDeclaration>& declarations, const Graph& graph) : graph_(graph) {
    for (const ComponentDeclaration& declaration : declarations) {
      const ComponentNode* node = graph.find(declaration.name);
      if (node == nullptr) {
        add({graph.path.string(), 0}, declaration.name, "", "is not a component of this graph");
        continue;
      }
      for (const auto& output : declaration.outputs) {
        if (const auto topic = checked_topic(*node, output.name))
          topics_[*topic].writers.push_back({node, &output});
      }
      for (const auto& input : declaration.inputs) {
        if (const auto topic = checked_topic(*node, input.name))
          topics_[*topic].readers.push_back({node, &input});
      }
      for (const auto& service : declaration.services) {
        if (const auto name = checked_topic(*node, service.name))
          services_[*name].servers.push_back({node, &service});
      }
      for (const auto& client : declaration.clients) {
        if (const auto name = checked_topic(*node, client.name))
          services_[*name].clients.push_back({node, &client});
      }
      check_names(declaration, *node);
    }
  }

  std::vector<Violation> check() {
    for (const auto& [name, topic] : topics_) {
      check_types(name, topic);
      check_owner(name, topic);
      check_qos(name, topic);
      check_fed(name, topic);
    }
    check_loops();
    for (const auto& [name, service] : services_) check_service(name, service);
    return std::move(violations_);
  }

 private:
  void add(const Location& where, const std::string& key, const std::string& value, const std::string& rule) {
    violations_.push_back({where, key, value, rule});
  }

  std::optional<std::string> checked_topic(const ComponentNode& node, const std::string& name) {
    std::string topic = node.topic_of(name);
    auto rule = topic_name_rule(name);
    if (!rule) rule = topic_name_rule(topic);
    if (!rule) return topic;
    add(node.where, joined(node.name, name), topic, *rule);
    return std::nullopt;
  }

  /// Every remap and every entry of inputs must speak of a name that the component has.
  void check_names(const ComponentDeclaration& declaration, const ComponentNode& node) {
    std::vector<std::string_view> inputs, all;
    for (const auto& input : declaration.inputs) inputs.push_back(without_action_part(input.name));
    for (const auto& client : declaration.clients) inputs.push_back(without_action_part(client.name));
    all = inputs;
    for (const auto& output : declaration.outputs) all.push_back(output.name);
    for (const auto& service : declaration.services) all.push_back(without_action_part(service.name));
    std::set<std::string> topics;
    for (const std::string_view name : all)
      topics.insert(resolve_name(node.node_namespace, node.node_name(), name));
    // Every node has a dozen private services, which nobody means who mistypes a topic.
    std::erase_if(all, [](std::string_view name) { return name.starts_with("~/"); });
    const std::string key = joined("components", node.name);
    for (const Remap& remap : node.remaps) {
      if (topics.contains(resolve_name(node.node_namespace, node.node_name(), remap.from))) continue;
      add(remap.where, joined(joined(key, "remap"), remap.from), "", unknown_rule("name", remap.from, all));
    }
    for (const InputSettings& input : node.inputs) {
      if (std::find(inputs.begin(), inputs.end(), input.name) != inputs.end()) continue;
      add(input.where, joined(joined(key, "inputs"), input.name), "",
          unknown_rule("input", input.name, inputs));
    }
  }

  template <class EndType>
  void check_type(const std::string& name, const EndType& end, const std::string& type,
                  const std::string& owner) {
    if (end.declared->type == type) return;
    add(end.node->where, end.key(), end.declared->type, name + " is " + type + " at " + owner);
  }

  void check_types(const std::string& name, const Topic& topic) {
    const bool written = !topic.writers.empty();
    const std::string& type = written ? topic.writers[0].declared->type : topic.readers[0].declared->type;
    const std::string owner = written ? topic.writers[0].owner() : topic.readers[0].owner();
    for (const auto& writer : topic.writers) check_type(name, writer, type, owner);
    for (const auto& reader : topic.readers) check_type(name, reader, type, owner);
  }

  void check_owner(const std::string& name, const Topic& topic) {
    const auto& writers = topic.writers;
    const auto owner =
        std::find_if(writers.begin(), writers.end(), [](const auto& w) { return w.declared->command; });
    if (owner == writers.end()) return;
    for (auto writer = writers.begin(); writer != writers.end(); ++writer) {
      if (writer == owner) continue;
      add(writer->node->where, writer->key(), "",
          name + " is a command and has a publisher already: " + owner->owner());
    }
  }

  void check_qos(const std::string& name, const Topic& topic) {
    for (const auto& reader : topic.readers) {
      for (const auto& writer : topic.writers) {
        const Qos &offered = writer.declared->qos, &requested = reader.declared->qos;
        if (offered.reliability < requested.reliability) {
          add(reader.node->where, reader.key(), reliability_text(requested),
              name + " is only " + reliability_text(offered) + " at " + writer.owner());
        }
        if (offered.durability < requested.durability) {
          add(reader.node->where, reader.key(), durability_text(requested),
              name + " is only " + durability_text(offered) + " at " + writer.owner());
        }
      }
    }
  }

  void check_fed(const std::string& name, const Topic& topic) {
    if (!topic.writers.empty()) return;
    for (const auto& reader : topic.readers) {
      const InputSettings* settings = reader.node->input(reader.declared->name);
      if (reader.declared->optional || (settings != nullptr && settings->external)) continue;
      std::vector<std::string_view> written;
      for (const auto& [other, ends] : topics_) {
        if (!ends.writers.empty() && ends.writers[0].declared->type == reader.declared->type)
          written.push_back(other);
      }
      std::string rule = "nobody publishes " + name + "; remap it, or mark the input external: true";
      if (const auto nearest = nearest_of(name, written))
        rule += "; did you mean " + std::string(*nearest) + "?";
      add(settings != nullptr ? settings->where : reader.node->where, reader.key(), "", rule);
    }
  }

  void check_service(const std::string& name, const Service& service) {
    const auto& servers = service.servers;
    for (std::size_t i = 1; i < servers.size(); ++i) {
      add(servers[i].node->where, servers[i].key(), "",
          name + " is a service and has a server already: " + servers[0].owner());
    }
    for (const auto& client : service.clients) {
      if (!servers.empty()) {
        check_type(name, client, servers[0].declared->type, servers[0].owner());
        continue;
      }
      const InputSettings* settings = client.node->input(client.declared->name);
      if (client.declared->optional || (settings != nullptr && settings->external)) continue;
      add(client.node->where, client.key(), "",
          "nobody offers the service " + name + "; remap it, or mark the input external: true");
    }
  }

  /// Who is called by whose command.
  using Obedience = std::map<const ComponentNode*, std::set<const ComponentNode*>>;

  /// An input that is left to others, and hears what comes of its component's own command, drives the robot
  /// by itself and for ever: a multiplexer that takes for a hand's what a monitor made of its command.
  void check_loops() {
    std::map<std::string, Obedience> by_type;
    for_each_command([&](const auto& writer, const auto& reader) {
      by_type[writer.declared->type][writer.node].insert(reader.node);
    });
    for_each_command([&](const auto& writer, const auto& reader) {
      const InputSettings* settings = reader.node->input(reader.declared->name);
      std::vector<const ComponentNode*> path{reader.node};
      if (settings == nullptr || !settings->external ||
          !leads_to(writer.node, by_type[writer.declared->type], path))
        return;
      std::string text;
      for (const ComponentNode* passed : path) text += passed->name + " -> ";
      add(settings->where, reader.key(), reader.node->topic_of(reader.declared->name),
          "is left to others and hears its own command back: " + text + reader.node->name + "; remap it");
    });
  }

  /// Ends of a command that call.
  template <class See>
  void for_each_command(See see) const {
    for (const auto& [name, topic] : topics_) {
      for (const auto& writer : topic.writers) {
        for (const auto& reader : topic.readers) {
          if (writer.declared->command && !reader.declared->only_newest) see(writer, reader);
        }
      }
    }
  }

  /// Extends `path` to `end` along commands; false when none leads there.
  static bool leads_to(const ComponentNode* end, const Obedience& obedience,
                       std::vector<const ComponentNode*>& path) {
    if (path.back() == end) return true;
    const auto next = obedience.find(path.back());
    if (next == obedience.end()) return false;
    for (const ComponentNode* node : next->second) {
      if (std::find(path.begin(), path.end(), node) != path.end()) continue;
      path.push_back(node);
      if (leads_to(end, obedience, path)) return true;
      path.pop_back();
    }
    return false;
  }

  const Graph& graph_;
  std::map<std::string, Topic> topics_;
  std::map<std::string, Service> services_;
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<Violation> check_graph(const std::vector<ComponentDeclaration>& declarations,
                                   const Graph& graph) {
  return Checker(declarations, graph).check();
}

}  // namespace bw
