#include "runtime/recording/replay/topic_player.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <rosgraph_msgs/msg/clock.hpp>

#include "runtime/host/statistics.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/recording/replay/latched.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/stamps.hpp"
#include "runtime/wire/serialization.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::replay {
namespace {

constexpr const char* kNodeName = "bandwagon_player";
constexpr Duration kLongestWait = Duration::milliseconds(100);  // between looks at the control
constexpr Duration kQuiet = Duration::milliseconds(500);        // discovery that tells nothing new is done
constexpr Duration kDiscovery = Duration::milliseconds(1300);   // one announcement period and a little
constexpr Duration kLongestDiscovery = Duration::milliseconds(3000);
constexpr Duration kLongestDelivery = Duration::milliseconds(2000);
constexpr Duration kHeartbeat =
    Duration::milliseconds(100);       // what was lost is sent again soon, and the end is known
constexpr std::uint64_t kLooks = 256;  // at rate 0: messages between looks at the control
constexpr double kRateStep = 0.1;

/// The bag's time at which playing begins.
Time start_of(const bag::Bag& recording, const PlayerOptions& options) {
  const Time start = recording.start() + options.start;
  if (recording.message_count() == 0) throw std::runtime_error("the bag has no messages");
  if (start > recording.end()) {
    throw std::runtime_error(fmt::format("--start {:.3f} lies behind the bag's end at {:.3f} s",
                                         options.start.to_seconds(),
                                         (recording.end() - recording.start()).to_seconds()));
  }
  return start;
}

TopicSelection selection_of(const PlayerOptions& options) {
  TopicSelection selection = options.selection;
  selection.without_clock = options.clock_hz.has_value();
  return selection;
}

}  // namespace

TopicPlayer::TopicPlayer(const bag::Bag& recording, const PlayerOptions& options)
    : recording_(recording),
      options_(options),
      played_(played_topics(recording.topics(), selection_of(options))),
      start_(start_of(recording, options)),
      participant_({.network = options.network}),
      announcement_(participant_, kNodeName) {
  open_writers();
  bag::BagSelection wanted{.start = start_};
  if (options_.duration) wanted.end = start_ + *options_.duration;
  wanted.topics.emplace();
  for (std::size_t i = 0; i < played_.size(); ++i) {
    if (played_[i]) wanted.topics->insert(recording_.topics()[i].name);
  }
  messages_ = recording_.messages(wanted);
}

void TopicPlayer::open_writers() {
  for (const auto& topic : played_) {
    Voice& voice = voices_.emplace_back();
    if (!topic) continue;
    // A type of a hash that nobody here knows is not for us to judge, nor is one without.
    if (!topic->type_hash.empty()) voice.type = find_type(topic->type, topic->type_hash);
    voice.writer = participant_.create_writer({.topic = dds_topic(topic->name),
                                               .type = dds_type(topic->type),
                                               .qos = topic->qos,
                                               .user_data = user_data_of(topic->type_hash),
                                               .heartbeat = kHeartbeat});
    announcement_.add(*voice.writer);
  }
  if (options_.clock_hz) {
    using Clock = MessageTraits<rosgraph_msgs::msg::Clock>;
    clock_ = participant_.create_writer({.topic = dds_topic("/clock"),
                                         .type = std::string(Clock::dds_name),
                                         .qos = Qos::standard(1),
                                         .user_data = user_data_of(std::string(Clock::type_hash))});
    announcement_.add(*clock_);
  }
  announcement_.publish();
  for (const std::string& name : options_.wait_for) awaited_.push_back(writer_of(name));
}

/// Any of the topic's.
const dds::Writer* TopicPlayer::writer_of(const std::string& name) const {
  if (name == "/clock" && clock_) return clock_.get();
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < played_.size(); ++i) {
    if (played_[i] && played_[i]->name == name) return voices_[i].writer.get();
    if (played_[i]) known.push_back(played_[i]->name);
  }
  throw std::runtime_error("--wait-for " + name + ": " + unknown_rule("topic", name, known));
}

/// Somebody reads each of the topics that were to be waited for.
bool TopicPlayer::is_heard() const {
  return std::ranges::all_of(awaited_,
                             [](const dds::Writer* writer) { return writer->matched_readers() > 0; });
}

/// False when the control wants the end.
bool TopicPlayer::wait_for_readers(PlayerControl& control) {
  const Duration begin = steady_time();
  Duration changed = begin;
  std::uint64_t known = participant_.endpoint_changes();
  for (Duration now = begin;; now = steady_time()) {
    const std::uint64_t changes = participant_.endpoint_changes();
    if (std::exchange(known, changes) != changes) changed = now;
    const bool is_settled = now - begin >= kDiscovery && now - changed >= kQuiet;
    if ((is_settled || now - begin >= kLongestDiscovery) && is_heard()) return true;
    if (control.wait(Duration::milliseconds(20), status()) == PlayerControl::Wish::end) return false;
  }
}

/// False at the end.
bool TopicPlayer::read() {
  for (;;) {
    const bag::Step step = messages_->next(message_);
    if (step == bag::Step::end) return false;
    if (step == bag::Step::damaged) {
      faults_.push_back(messages_->fault());
    } else if (played_[message_.topic]) {
      return true;
    }
  }
}

PlayerStatus TopicPlayer::run(PlayerControl& control) {
  if (!wait_for_readers(control)) return status();
  for (const LatchedMessage& latched : latched_before(recording_, start_, played_)) {
    if (publish(latched.topic, latched.cdr)) ++status_.latched;
  }
  began_ = steady_time();
  schedule_.emplace(PlayScheduleOptions{.start = start_,
                                        .rate = options_.rate,
                                        .clock_hz = options_.clock_hz.value_or(0.0),
                                        .is_paused = options_.is_paused},
                    began_);
  play(control);
  return status();
}

void TopicPlayer::play(PlayerControl& control) {
  for (bool has_message = read(); has_message;) {
    const Duration now = steady_time();
    const PlayStep step = schedule_->next(message_.log_time, now);
    if (step.what == PlayStep::What::clock) {
      publish_clock(schedule_->position(now));
    } else if (step.what == PlayStep::What::message) {
      status_.latest = std::max(status_.latest, step.late);
      if (publish(message_.topic, message_.data)) ++status_.published;
      has_message = read();
      const bool looks = options_.rate == 0.0 && status_.published % kLooks == 0;
      if (looks && !obey(control.wait({}, status()))) return;
    } else {
      const Duration rest = step.until ? *step.until - now : kLongestWait;
      if (!obey(control.wait(std::min(rest, kLongestWait), status()))) return;
    }
  }
  status_.took = steady_time() - began_;
  wait_for_delivery();
}

void TopicPlayer::wait_for_delivery() {
  const Duration end = steady_time() + kLongestDelivery;
  for (const Voice& voice : voices_) {
    if (voice.writer) voice.writer->wait_until_received(std::max(end - steady_time(), Duration{}));
  }
}

std::size_t TopicPlayer::topics() const {
  std::set<std::string> names;
  for (const auto& topic : played_) {
    if (topic) names.insert(topic->name);
  }
  return names.size();
}

bool TopicPlayer::obey(PlayerControl::Wish wish) {
  using Wish = PlayerControl::Wish;
  const Duration now = steady_time();
  if (wish == Wish::pause) schedule_->set_paused(!schedule_->is_paused(), now);
  if (wish == Wish::step && schedule_->is_paused()) schedule_->step();
  if (wish == Wish::faster) schedule_->set_rate(schedule_->rate() + kRateStep, now);
  if (wish == Wish::slower) schedule_->set_rate(std::max(schedule_->rate() - kRateStep, kRateStep), now);
  return wish != Wish::end;
}

bool TopicPlayer::publish(std::size_t topic, bag::BytesView cdr) {
  const Voice& voice = voices_[topic];
  if (voice.type != nullptr && !validate(*voice.type, cdr)) {
    ++status_.malformed;
    return false;
  }
  const bool is_written = voice.writer->write(cdr);
  if (!is_written) ++status_.refused;
  return is_written;
}

void TopicPlayer::publish_clock(Time position) {
  rosgraph_msgs::msg::Clock message;
  message.clock(to_stamp(position));
  std::vector<std::uint8_t> cdr;
  serialize(message, cdr);
  clock_->write(cdr);
}

const PlayerStatus& TopicPlayer::status() {
  const Time position = schedule_ ? schedule_->position(steady_time()) : start_;
  status_.position = std::min(position, recording_.end()) - recording_.start();
  status_.is_waiting = !schedule_;
  status_.is_paused = schedule_ ? schedule_->is_paused() : options_.is_paused;
  status_.rate = schedule_ ? schedule_->rate() : options_.rate;
  return status_;
}

}  // namespace bw::replay
