#include "runtime/remote/foxglove/wire_topics.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "runtime/graph/names.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::foxglove {
namespace {

using std::chrono::steady_clock;

constexpr int kTopicDepth = 200;  // samples of a topic that may wait for the server's thread
constexpr int kMaxAtOnce = 64;
// Pages come and go, and so would readers, which every process of the domain is told of.
constexpr std::chrono::milliseconds kLinger{3000};

bool is_same_kind(const Qos& a, const Qos& b) {
  return a.reliability == b.reliability && a.durability == b.durability;
}

}  // namespace

WireTopics::WireTopics(WireLink& link, WireClock& clock)
    : link_(link), clock_(clock), taking_(link.post, [this] { take_queued(); }) {}

void WireTopics::look(const std::vector<dds::Endpoint>& endpoints) {
  std::set<dds::Guid> there;
  for (const dds::Endpoint& e : endpoints) {
    if (e.is_writer) there.insert(e.guid);
  }
  const std::vector<std::uint32_t> removed = forget_the_gone(there);
  if (!removed.empty() && link_.listener != nullptr) link_.listener->on_channels({}, removed);

  std::vector<Channel> added;
  for (const dds::Endpoint& e : endpoints) {
    if (!e.is_writer || sources_.contains(e.guid) || !e.topic.starts_with("rt/")) continue;
    if (topic_name_rule(ros_topic(e.topic))) continue;  // any DDS program may be there
    const TypeDescription* type = type_of(e);
    if (type == nullptr) continue;
    const std::size_t known = topics_.size();
    add_source(e, *type);
    if (topics_.size() > known) added.push_back(topics_.at(sources_.at(e.guid).channel).channel);
  }
  if (!added.empty() && link_.listener != nullptr) link_.listener->on_channels(added, {});
}

/// Null where it is not shown, which is said once.
const TypeDescription* WireTopics::type_of(const dds::Endpoint& writer) {
  const std::string topic = ros_topic(writer.topic);
  const TypeDescription* type = find_type(ros_type(writer.type), type_hash_in(writer.user_data));
  const auto other = channel_of_.find(topic);
  std::string why;
  if (type == nullptr) {
    why = "this program does not know the type";
  } else if (other != channel_of_.end() && topics_.at(other->second).type != type) {
    why = "the topic is shown as another type, " + topics_.at(other->second).channel.schema_name;
  }
  if (why.empty()) return type;
  if (told_.emplace(topic, writer.type).second)
    link_.say(1, topic + " (" + ros_type(writer.type) + ") is not shown: " + why);
  return nullptr;
}

std::uint32_t WireTopics::id_of(const std::string& topic, const TypeDescription& type) {
  const auto next = static_cast<std::uint32_t>(ids_.size() + 1);
  return ids_.emplace(std::pair(topic, &type), next).first->second;
}

void WireTopics::add_source(const dds::Endpoint& writer, const TypeDescription& type) {
  const std::string name = ros_topic(writer.topic);
  const std::uint32_t id = id_of(name, type);
  Topic& topic = topics_[id];
  if (topic.type == nullptr) {
    topic.channel = {
        .id = id, .topic = name, .schema_name = std::string(type.ros_name), .schema = bag::schema_text(type)};
    topic.type = &type;
    topic.dds_type = writer.type;
    topic.user_data = writer.user_data;
    channel_of_[name] = id;
  }
  if (writer.qos.durability == Durability::transient_local) topic.channel.is_latched = true;
  sources_[writer.guid] = {.channel = id, .offer = writer.qos, .intake = {}, .last = {}};
  if (topic.subscribers > 0) open_ears(topic);
}

/// Channels without a writer; who had subscribed to one has not any more.
std::vector<std::uint32_t> WireTopics::forget_the_gone(const std::set<dds::Guid>& there) {
  std::set<std::uint32_t> alive;
  std::erase_if(sources_, [&](const auto& item) { return !there.contains(item.first); });
  for (const auto& [guid, source] : sources_) alive.insert(source.channel);
  std::vector<std::uint32_t> removed;
  for (auto& [id, topic] : topics_) {
    if (alive.contains(id)) continue;
    close_ears(topic);
    channel_of_.erase(topic.channel.topic);
    removed.push_back(id);
  }
  for (const std::uint32_t id : removed) topics_.erase(id);
  return removed;
}

std::vector<Channel> WireTopics::channels() const {
  std::vector<Channel> all;
  for (const auto& [id, topic] : topics_) all.push_back(topic.channel);
  return all;
}

void WireTopics::subscribe(std::uint32_t channel) {
  const auto found = topics_.find(channel);
  if (found == topics_.end()) return;
  ++found->second.subscribers;
  open_ears(found->second);
}

void WireTopics::unsubscribe(std::uint32_t channel) {
  const auto found = topics_.find(channel);
  if (found == topics_.end() || found->second.subscribers == 0) return;
  if (--found->second.subscribers == 0) found->second.unwanted_since = steady_clock::now();
}

std::vector<std::pair<Time, SharedBytes>> WireTopics::latched(std::uint32_t channel) const {
  std::vector<std::pair<Time, SharedBytes>> all;
  for (const auto& [guid, source] : sources_) {
    if (source.channel == channel && source.last) all.push_back(*source.last);
  }
  return all;
}

void WireTopics::open_ears(Topic& topic) {
  for (const auto& [guid, source] : sources_) {
    if (source.channel != topic.channel.id) continue;
    const bool is_open = std::ranges::any_of(
        topic.ears, [&](const auto& ear) { return is_same_kind(ear->offer, source.offer); });
    if (!is_open) open_ear(topic, source.offer);
  }
}

void WireTopics::open_ear(Topic& topic, const Qos& offer) {
  auto ear = std::make_shared<Ear>();
  ear->channel = topic.channel.id;
  ear->offer = offer;
  const Qos qos{.reliability = offer.reliability, .durability = offer.durability, .depth = kTopicDepth};
  clock_.want(true);
  try {
    ear->reader =
        link_.participant.create_reader({.topic = dds_topic(topic.channel.topic),
                                         .type = topic.dds_type,
                                         .qos = qos,
                                         .user_data = topic.user_data,
                                         .allocated_samples = 1},
                                        [queue = queue_, one = std::weak_ptr(ear), ring = taking_.bell()] {
                                          const auto alive = one.lock();
                                          if (!alive || alive->is_queued.exchange(true)) return;
                                          {
                                            const std::lock_guard lock(queue->mutex);
                                            queue->ears.push_back(one);
                                          }
                                          ring();
                                        });
  } catch (const std::runtime_error& error) {
    link_.say(2, topic.channel.topic + " cannot be heard: " + error.what());
  }
  if (ear->reader) {
    link_.add(*ear->reader);
  }
  if (topic.ears.empty()) ++open_count_;
  topic.ears.push_back(std::move(ear));
}

void WireTopics::close_ears(Topic& topic) {
  if (topic.ears.empty()) return;
  for (const auto& ear : topic.ears) {
    if (ear->reader) link_.remove(*ear->reader);
    ear->reader.reset();
  }
  topic.ears.clear();
  --open_count_;
  // Who is heard again begins anew: with what is latched.
  for (auto& [guid, source] : sources_) {
    if (source.channel != topic.channel.id) continue;
    source.intake = {};
    source.last.reset();
  }
}

void WireTopics::tick(steady_clock::time_point now) {
  for (auto& [id, topic] : topics_) {
    if (topic.subscribers == 0 && now - topic.unwanted_since > kLinger) close_ears(topic);
  }
  clock_.want(is_listening());
  taking_.ring();
}

void WireTopics::enqueue(const std::shared_ptr<Ear>& ear) {
  if (ear->is_queued.exchange(true)) return;
  const std::lock_guard lock(queue_->mutex);
  queue_->ears.push_back(ear);
}

/// A little of each topic; others have work for this thread too.
void WireTopics::take_queued() {
  if (!clock_.is_known()) return;  // tick() comes back to it
  std::vector<std::weak_ptr<Ear>> due;
  {
    const std::lock_guard lock(queue_->mutex);
    due.swap(queue_->ears);
  }
  bool is_more = false;
  for (const auto& one : due) {
    const auto ear = one.lock();
    if (!ear) continue;
    ear->is_queued = false;  // before the take: a sample that arrives from now on queues it again
    if (!ear->reader || !take_some(*ear)) continue;
    enqueue(ear);
    is_more = true;
  }
  if (is_more) taking_.ring();
}

/// False when nothing is left.
bool WireTopics::take_some(Ear& ear) {
  for (int i = 0; i < kMaxAtOnce; ++i) {
    if (!ear.reader || !ear.reader->take(sample_)) return false;
    if (!link_.is_own(sample_.writer)) take(ear, sample_);
  }
  return true;
}

void WireTopics::take(const Ear& ear, const dds::Sample& sample) {
  // A writer that discovery has not told of yet, or that came and went, is one as the ear is made for.
  Source& source =
      sources_
          .try_emplace(sample.writer,
                       Source{.channel = ear.channel, .offer = ear.offer, .intake = {}, .last = {}})
          .first->second;
  if (!source.intake.accept(sample.sequence, is_same_kind(ear.offer, source.offer))) return;
  const auto found = topics_.find(source.channel);
  if (found == topics_.end()) return;
  Topic& topic = found->second;
  const auto size = message_size(*topic.type, sample.cdr);
  if (!size) {
    if (!std::exchange(topic.is_malformed, true))
      link_.say(1,
                topic.channel.topic + ": a message that is no " + topic.channel.schema_name + " is left out");
    return;
  }
  const bool is_latched = source.offer.durability == Durability::transient_local;
  if (topic.subscribers == 0 && !is_latched) return;
  const auto end = sample.cdr.begin() + static_cast<std::ptrdiff_t>(*size);
  const auto bytes = std::make_shared<const Bytes>(sample.cdr.begin(), end);
  const Time time = clock_.time_of(sample.received);
  if (is_latched) source.last = {time, bytes};
  if (topic.subscribers == 0 || link_.listener == nullptr) return;
  clock_.tell(time);
  link_.listener->on_message(topic.channel.id, time, bytes);
}

}  // namespace bw::foxglove
