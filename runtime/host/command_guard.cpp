#include "runtime/host/command_guard.hpp"

#include <algorithm>

#include "runtime/host/actor.hpp"

namespace bw {

std::vector<CommandTopic> find_commands(const std::vector<Actor*>& all, const std::vector<Actor*>& local) {
  std::map<std::string, std::string> commanders;
  for (const Actor* actor : all) {
    for (const auto& output : actor->outputs) {
      if (output->command)
        commanders[output->topic] = full_name({.node_namespace = actor->node_namespace, .name = actor->name});
    }
  }
  std::map<std::string, CommandTopic> found;
  std::map<std::string, std::string_view> type_of;
  for (Actor* actor : local) {
    for (const auto& input : actor->inputs) {
      const auto commander = commanders.find(input->topic);
      if (commander == commanders.end() || input->is_external) continue;
      input->commander = commander->second;
      found[input->topic] = {.topic = input->topic, .owner = commander->second};
      type_of[input->topic] = input->type.ros_name;
    }
  }
  std::vector<CommandTopic> topics;
  for (auto& [name, topic] : found) {
    for (const Actor* actor : all) {
      for (const auto& input : actor->inputs) {
        if (input->is_external && input->type.ros_name == type_of[name]) topic.open.push_back(input->topic);
      }
    }
    topics.push_back(std::move(topic));
  }
  return topics;
}

std::vector<CommandWatch::News> CommandGuard::look(Time now) {
  const bool has_names = directory_.update();
  const std::uint64_t changes = participant_.endpoint_changes();
  if (!has_names && changes == changes_ && !watch_.is_waiting()) return {};
  changes_ = changes;
  auto news = watch_.look(
      participant_.endpoints(), participant_.take_departed(),
      [this](const dds::Guid& guid) { return directory_.node_of(guid); }, now);
  std::vector<dds::Guid> alive = participant_.remote_participants();
  alive.push_back(participant_.guid());
  directory_.keep_only(alive);
  return news;
}

}  // namespace bw
