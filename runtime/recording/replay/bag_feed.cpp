#include "runtime/recording/replay/bag_feed.hpp"

#include <algorithm>
#include <utility>

#include "runtime/recording/bag/known_type.hpp"
#include "runtime/recording/bag/message_stamp.hpp"
#include "runtime/recording/bag/qos_text.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::replay {

/// Owns the outputs; everything else is the feed's.
class BagFeed::Player final : public Component {
 public:
  explicit Player(BagFeed& feed) : feed_(feed) {}

  void configure(Setup& setup) override {
    const std::vector<bag::BagTopic>& topics = feed_.recording_.topics();
    for (std::size_t i = 0; i < topics.size(); ++i) {
      if (feed_.roles_[i] != Role::played && feed_.roles_[i] != Role::refused) continue;
      const MessageType type{
          .ros_name = topics[i].type, .dds_name = feed_.dds_names_[i], .type_hash = topics[i].type_hash};
      feed_.ports_[i] = setup.raw_output(
          topics[i].name, type, bag::playing_qos(bag::from_qos_text(topics[i].offered_qos_profiles)));
    }
  }
  void activate(const Tick& tick) override {
    feed_.is_active_ = true;
    feed_.run(tick.now);
  }
  void deactivate(const Tick&) override { feed_.is_active_ = false; }

 private:
  BagFeed& feed_;
};

BagFeed::BagFeed(const bag::Bag& recording, FeedOptions options, OutputComparison& comparison)
    : recording_(recording),
      options_(std::move(options)),
      comparison_(comparison),
      messages_(reordered(recording.messages({}), options_.delays)) {
  for (const bag::BagTopic& topic : recording.topics()) ++writers_[topic.name];
  for (const bag::BagTopic& topic : recording.topics()) {
    const bool is_live = std::ranges::any_of(options_.live, [&](const auto& live) {
      return live.first == topic.name && (topic.writer.empty() || live.second == topic.writer);
    });
    roles_.push_back(is_live                                 ? Role::live
                     : options_.ignored.contains(topic.name) ? Role::ignored
                                                             : Role::played);
    if (is_live) comparison_.add_topic(name_of(topic.name, topic.writer), topic.type);
    const bag::KnownType known = bag::known_type(topic);
    types_.push_back(known.type);
    if (roles_.back() == Role::played && !known.why.empty()) {
      roles_.back() = Role::refused;
      refused_.push_back(topic.name + " is not played: " + known.why);
    }
    dds_names_.push_back(dds_type(topic.type));
  }
  ports_.resize(roles_.size(), nullptr);
  read();
}

/// As the verdict names it: the topic, and the node where a topic has several.
std::string BagFeed::name_of(const std::string& topic, const std::string& node) const {
  const auto writers = writers_.find(topic);
  return writers != writers_.end() && writers->second > 1 ? topic + " (" + node + ")" : topic;
}

std::unique_ptr<Component> BagFeed::make_component() { return std::make_unique<Player>(*this); }

void BagFeed::read() {
  pending_.reset();
  pending_is_told_ = false;
  while (read_ < options_.messages) {
    bag::BagMessage message;
    const bag::Step step = messages_->next(message);
    if (step == bag::Step::end) return;
    if (step == bag::Step::damaged) {
      if (!damage_) damage_ = messages_->fault();
      continue;
    }
    ++read_;
    if (roles_[message.topic] == Role::ignored || roles_[message.topic] == Role::refused) continue;
    pending_ = message;
    return;
  }
}

std::optional<Time> BagFeed::next() const {
  if (!pending_) return std::nullopt;
  // A running component still owes a message of an instant that is over: the next nanosecond gives it up.
  if (last_run_ && pending_->log_time <= *last_run_) return *last_run_ + Duration{1};
  return pending_->log_time;
}

void BagFeed::run(Time now) {
  last_run_ = now;
  advance(now);
}

void BagFeed::advance(Time now) {
  while (pending_ && pending_->log_time <= now) {
    const bag::BagTopic& recorded = recording_.topics()[pending_->topic];
    if (roles_[pending_->topic] == Role::played) {
      publish();
      read();
      continue;
    }
    const std::string topic = name_of(recorded.name, recorded.writer);
    if (!std::exchange(pending_is_told_, true)) comparison_.expect(topic, pending_->log_time, pending_->data);
    std::int64_t& ahead = ahead_[topic];
    if (ahead <= 0 && pending_->log_time == now) return;  // it will come within this instant
    --ahead;
    read();
  }
}

void BagFeed::publish() {
  const std::size_t topic = pending_->topic;
  if (types_[topic] != nullptr && !validate(*types_[topic], pending_->data)) {
    ++malformed_;
    return;
  }
  if (ports_[topic] == nullptr || !is_active_) return;
  ports_[topic]->publish(pending_->data);
  ++published_;
  if (options_.on_message)
    options_.on_message(topic, pending_->log_time, pending_->publish_time, pending_->data);
}

void BagFeed::tell_live(const std::string& topic, const std::string& node, Time now,
                        bag::BytesView cdr) const {
  const std::vector<bag::BagTopic>& topics = recording_.topics();
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if (topics[i].name != topic || (!topics[i].writer.empty() && topics[i].writer != node)) continue;
    const bool has_stamp = types_[i] != nullptr && bag::begins_with_stamp(*types_[i]);
    options_.on_message(i, now, has_stamp ? bag::stamp_of(cdr).value_or(now) : now, cdr);
    return;
  }
}

void BagFeed::on_live(const std::string& topic, const std::string& node, Time now, bag::BytesView cdr) {
  if (options_.on_message) tell_live(topic, node, now, cdr);
  const std::string name = name_of(topic, node);
  comparison_.got(name, now, cdr);
  ++ahead_[name];
  advance(now);
}

void BagFeed::finish() {
  for (; pending_; read()) {
    if (roles_[pending_->topic] != Role::live || std::exchange(pending_is_told_, true)) continue;
    const bag::BagTopic& topic = recording_.topics()[pending_->topic];
    comparison_.expect(name_of(topic.name, topic.writer), pending_->log_time, pending_->data);
  }
}

}  // namespace bw::replay
