#include "runtime/remote/foxglove/wire_publisher.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "runtime/graph/names.hpp"
#include "runtime/remote/foxglove/message_json.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::foxglove {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kReaderPatience{
    1000};  // with readers that do not come, where another is there
constexpr std::chrono::milliseconds kLongPatience{
    5000};  // where none is: discovery takes seconds on a busy machine
constexpr std::chrono::milliseconds kWriterLinger{2000};  // until the last sample has arrived
constexpr std::size_t kMaxWaiting = 100;

/// geometry_msgs/PoseStamped -> geometry_msgs/msg/PoseStamped
std::string full_type(const std::string& type) {
  const std::size_t slash = type.find('/');
  if (slash == std::string::npos || type.find('/', slash + 1) != std::string::npos) return type;
  return type.substr(0, slash) + "/msg" + type.substr(slash);
}

}  // namespace

WirePublisher::WirePublisher(WireLink& link, std::string refusal)
    : link_(link), refusal_(std::move(refusal)), flushing_(link.post, [this] { flush(); }) {}

std::optional<std::string> WirePublisher::advertise(const std::string& name, const std::string& type) {
  if (const auto rule = topic_name_rule(name)) return name + ": " + *rule;
  if (name.starts_with('~') || name.starts_with('.')) return name + ": must be absolute, no name of a node";
  const std::string topic = join_namespaces("/", name);
  const auto known = topics_.find(topic);
  if (known == topics_.end()) return open(topic, full_type(type));
  if (known->second.type->ros_name != full_type(type))
    return topic + " is advertised as " + std::string(known->second.type->ros_name) + " already";
  ++known->second.advertised;
  return std::nullopt;
}

std::optional<std::string> WirePublisher::open(const std::string& topic, const std::string& type) {
  std::string hash;
  Qos qos = Qos::standard();
  for (const dds::Endpoint& e : link_.participant.endpoints()) {
    if (e.topic != dds_topic(topic) || e.is_local) continue;
    if (ros_type(e.type) != type) return topic + " carries " + ros_type(e.type) + ", not " + type;
    if (hash.empty() || !e.is_writer) hash = type_hash_in(e.user_data);
    if (!e.is_writer) qos.durability = std::max(qos.durability, e.qos.durability);
  }
  const TypeDescription* layout = find_type(type, hash);
  if (layout == nullptr) return type + ": this program does not know the type";
  Topic one{.type = layout,
            .advertised = 1,
            .writer = {},
            .opened = steady_clock::now(),
            .unwanted_since = {},
            .waiting = {}};
  try {
    one.writer = link_.participant.create_writer({.topic = dds_topic(topic),
                                                  .type = std::string(layout->dds_name),
                                                  .qos = qos,
                                                  .user_data = user_data_of(std::string(layout->type_hash)),
                                                  .heartbeat = dds::kPromptHeartbeat},
                                                 flushing_.bell());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  link_.add(*one.writer);
  topics_[topic] = std::move(one);
  return std::nullopt;
}

std::optional<std::string> WirePublisher::publish(const std::string& name,
                                                  std::span<const std::uint8_t> cdr) {
  const std::string topic = join_namespaces("/", name);
  if (!refusal_.empty()) return topic + ": " + refusal_;
  const auto known = topics_.find(topic);
  if (known == topics_.end() || known->second.advertised == 0) return topic + " is not advertised";
  Topic& one = known->second;
  std::string broken;
  if (!validate(*one.type, cdr, &broken))
    return topic + ": no " + std::string(one.type->ros_name) + ": " + broken;
  if (one.waiting.size() >= kMaxWaiting) return topic + ": too many messages before anybody hears them";
  one.waiting.emplace_back(cdr.begin(), cdr.end());
  flush();
  return std::nullopt;
}

std::optional<std::string> WirePublisher::publish_json(const std::string& name, std::string_view json) {
  const std::string topic = join_namespaces("/", name);
  const auto known = topics_.find(topic);
  if (known == topics_.end()) return topic + " is not advertised";
  try {
    return publish(topic, message_from_json(*known->second.type, json));
  } catch (const std::runtime_error& error) {
    return topic + ": " + error.what();
  }
}

bool WirePublisher::has_readers(const std::string& topic, const Topic& one) {
  const auto waited = steady_clock::now() - one.opened;
  bool is_anybody_there = false;
  bool is_anybody_missing = false;
  for (const dds::Endpoint& e : link_.participant.endpoints()) {
    if (e.is_writer || e.is_local || e.topic != dds_topic(topic)) continue;
    (one.writer->is_matched(e.guid) ? is_anybody_there : is_anybody_missing) = true;
  }
  if (is_anybody_there) return !is_anybody_missing || waited > kReaderPatience;
  return waited > kLongPatience;  // discovery may not have told of anybody yet
}

void WirePublisher::flush() {
  for (auto& [topic, one] : topics_) {
    if (one.waiting.empty() || !has_readers(topic, one)) continue;
    for (const auto& cdr : std::exchange(one.waiting, {})) one.writer->write(cdr);
  }
}

void WirePublisher::unadvertise(const std::string& name) {
  const auto known = topics_.find(join_namespaces("/", name));
  if (known == topics_.end() || known->second.advertised == 0) return;
  if (--known->second.advertised == 0) known->second.unwanted_since = steady_clock::now();
}

void WirePublisher::tick(steady_clock::time_point now) {
  flush();
  for (auto& [topic, one] : topics_)
    if (!one.waiting.empty()) one.unwanted_since = now;  // it is still to be written
  std::erase_if(topics_, [&](const auto& item) {
    const Topic& one = item.second;
    const bool is_over = one.advertised == 0 && now - one.unwanted_since > kWriterLinger;
    if (is_over) link_.remove(*one.writer);
    return is_over;
  });
}

bool WirePublisher::is_busy() const {
  return std::ranges::any_of(
      topics_, [](const auto& item) { return item.second.advertised == 0 || !item.second.waiting.empty(); });
}

}  // namespace bw::foxglove
