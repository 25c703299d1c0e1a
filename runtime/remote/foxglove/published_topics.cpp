#include "runtime/remote/foxglove/published_topics.hpp"

#include <algorithm>

namespace bw::foxglove {

std::optional<std::string> full_type_name(std::string_view type) {
  const std::size_t slash = type.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const std::string_view package = type.substr(0, slash);
  std::string_view name = type.substr(slash + 1);
  if (name.starts_with("msg/")) name.remove_prefix(4);
  if (package.empty() || name.empty() || name.find('/') != std::string_view::npos) return std::nullopt;
  return std::string(package) + "/msg/" + std::string(name);
}

std::optional<std::string> PublishedTopics::acquire(const std::string& topic, const std::string& type) {
  const std::optional<std::string> full = full_type_name(type);
  if (!full) return "type \"" + type + "\" is not of the form package/Name or package/msg/Name";
  const auto used = uses_.find(topic);
  if (used == uses_.end()) {
    if (auto reason = robot_.advertise(topic, *full)) return reason;
    uses_[topic] = {*full, 1};
    return std::nullopt;
  }
  if (used->second.type != *full)
    return "a client publishes there as " + used->second.type + ", not as " + *full;
  ++used->second.count;
  return std::nullopt;
}

void PublishedTopics::release(const std::string& topic) {
  const auto used = uses_.find(topic);
  if (used == uses_.end() || --used->second.count > 0) return;
  uses_.erase(used);
  robot_.unadvertise(topic);
}

}  // namespace bw::foxglove
