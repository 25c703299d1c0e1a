#include "runtime/host/command_guard.hpp"

#include <algorithm>
#include <utility>

#include "runtime/host/actor.hpp"

namespace bw {

std::vector<WatchedTopic> find_watched_topics(const std::vector<Actor*>& all,
                                              const std::vector<Actor*>& local) {
  std::map<std::string, std::string> commanders;
  std::map<std::string_view, std::vector<std::string>> open;  // by type
  for (const Actor* actor : all) {
    for (const auto& output : actor->outputs) {
      if (output->command)
        commanders[output->topic] =
            full_name({.node_namespace = actor->node_namespace, .name = actor->node_name});
    }
    for (const auto& input : actor->inputs) {
      if (input->is_external) open[input->type.ros_name].push_back(input->topic);
    }
  }
  std::map<std::string, WatchedTopic> found;
  for (Actor* actor : local) {
    for (const auto& input : actor->inputs) {
      const auto commander = commanders.find(input->topic);
      if (input->is_external) {
        found.try_emplace(input->topic, WatchedTopic{input->topic, std::string(input->type.ros_name)});
      } else if (commander != commanders.end()) {
        input->commander = commander->second;
        found[input->topic] = {input->topic, std::string(input->type.ros_name), commander->second,
                               open[input->type.ros_name]};
      }
    }
  }
  std::vector<WatchedTopic> topics;
  for (auto& [name, topic] : found) topics.push_back(std::move(topic));
  return topics;
}

std::map<std::string, std::uint64_t> CommandGuard::count_refused() const {
  std::map<std::string, std::uint64_t> counts;
  for (const Actor* actor : local_) {
    for (const auto& input : actor->inputs) {
      if (!input->commander.empty()) counts[input->topic] += input->refused;
    }
  }
  return counts;
}

std::vector<CommandWatch::News> CommandGuard::look(Time now) {
  const std::map<std::string, std::uint64_t> refused = count_refused();
  const std::map<std::string, std::uint64_t> before = std::exchange(refused_, refused);
  const bool has_names = directory_.update();
  const std::uint64_t changes = participant_.endpoint_changes();
  if (!has_names && changes == changes_ && !watch_.is_waiting() && refused == before) return {};
  changes_ = changes;
  auto news = watch_.look(
      participant_.endpoints(), participant_.take_departed(),
      [this](const dds::Guid& guid) { return directory_.node_of(guid); }, now,
      [&](const std::string& topic) {
        const auto count = refused.find(topic);
        const auto earlier = before.find(topic);
        return count != refused.end() && earlier != before.end() && count->second > earlier->second;
      });
  directory_.forget_the_gone();
  return news;
}

}  // namespace bw
