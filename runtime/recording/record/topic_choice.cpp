#include "runtime/recording/record/topic_choice.hpp"

#include <algorithm>
#include <stdexcept>

#include "runtime/graph/names.hpp"

namespace bw::record {
namespace {

std::string absolute(const std::string& name) {
  if (const auto rule = topic_name_rule(name)) throw std::runtime_error(name + ": " + *rule);
  return join_namespaces("/", name);
}

}  // namespace

TopicChoice::TopicChoice(const TopicChoiceOptions& options)
    : exclude_(options.exclude), all_(options.all), hidden_(options.hidden) {
  const bool is_named = !options.topics.empty() || !options.nodes.empty();
  if (!is_named && !all_) throw std::runtime_error("nothing to record: name topics, --node or --all");
  if (is_named && all_) throw std::runtime_error("--all is everything: it goes without topics and --node");
  if (exclude_ && !all_ && options.nodes.empty())
    throw std::runtime_error("--exclude needs --all or --node: topics that are named are recorded");
  for (const std::string& topic : options.topics) topics_.insert(absolute(topic));
  for (const std::string& node : options.nodes) nodes_.insert(absolute(node));
}

bool TopicChoice::wants(const std::string& topic, const std::set<std::string>& nodes) const {
  if (topics_.contains(topic)) return true;
  if (exclude_ && std::regex_search(topic, *exclude_)) return false;
  if (all_) return hidden_ || topic.find("/_") == std::string::npos;
  return std::ranges::any_of(nodes, [&](const std::string& node) { return nodes_.contains(node); });
}

}  // namespace bw::record
