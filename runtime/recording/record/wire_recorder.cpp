#include "runtime/recording/record/wire_recorder.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <utility>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <fmt/format.h>
#include <rosgraph_msgs/msg/clock.hpp>

#include "runtime/build_identity.hpp"
#include "runtime/graph/names.hpp"
#include "runtime/recording/bag/message_stamp.hpp"
#include "runtime/recording/bag/qos_text.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/diagnostic_value.hpp"
#include "runtime/stamps.hpp"
#include "runtime/thrown.hpp"
#include "runtime/wire/serialization.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::record {
namespace {

using std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr const char* kNodeName = "bandwagon_recorder";
// Samples bear the time of their arrival, so that taking them may wait: fewer wake-ups cost less.
constexpr auto kPeriod = 10ms;
constexpr int kDepth = 1000;  // that many samples of a topic may come in between
constexpr int kMaxAtOnce = 64;
constexpr auto kLongestUnnamed = 1000ms;  // nodes name their ends a moment after they make them
constexpr std::size_t kMaxHeld = std::size_t{16} << 20;  // [bytes]
constexpr std::uint32_t kReceiveBuffer = 4 << 20;        // [bytes]
constexpr std::size_t kMaxClockSteps = 1000;
constexpr auto kReportPeriod = 1000ms;

bool is_own(const dds::Guid& endpoint, const dds::Guid& participant) {
  return std::equal(endpoint.begin(), endpoint.begin() + 12, participant.begin());
}

/// As run_recorder names it: a node of the root namespace by its name alone.
std::string writer_name(const std::string& full_name) {
  return full_name.rfind('/') == 0 ? full_name.substr(1) : full_name;
}

template <class M>
dds::EndpointOptions endpoint(const std::string& topic, const Qos& qos) {
  return {.topic = dds_topic(topic),
          .type = std::string(MessageTraits<M>::dds_name),
          .qos = qos,
          .user_data = user_data_of(std::string(MessageTraits<M>::type_hash))};
}

}  // namespace

WireRecorder::WireRecorder(const std::filesystem::path& path, WireRecorderOptions options)
    : options_(std::move(options)),
      choice_(options_.choice),
      recorder_(path, options_.recorder),
      participant_({.network = options_.network, .receive_buffer = kReceiveBuffer}),
      directory_(participant_),
      announcement_(participant_, kNodeName) {
  using diagnostic_msgs::msg::DiagnosticArray;
  recorder_.add_metadata("bandwagon", {{"version", program_version()},
                                       {"revision", source_revision()},
                                       {"build_id", build_id()},
                                       {"cpu", cpu_type()},
                                       {"host", host_name()},
                                       {"clock", options_.use_sim_time ? "topic" : "wall"}});
  diagnostics_ = participant_.create_writer(endpoint<DiagnosticArray>("/diagnostics", Qos::standard()));
  announcement_.add(*diagnostics_);
  if (options_.use_sim_time) {
    Qos qos = Qos::clock();
    qos.depth = kDepth;
    clock_reader_ = participant_.create_reader(endpoint<rosgraph_msgs::msg::Clock>("/clock", qos), [] {});
    announcement_.add(*clock_reader_);
  }
  announcement_.publish();
  thread_ = std::thread([this] {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(status_mutex_);
      failure_ = thrown_text();
    }
  });
}

WireRecorder::~WireRecorder() { close(); }

WireRecorderStatus WireRecorder::status() const {
  const std::lock_guard lock(status_mutex_);
  WireRecorderStatus status{.bag = recorder_.status(), .lost = lost_, .topics = recorded_topics_.size()};
  if (status.bag.error.empty()) status.bag.error = failure_;
  return status;
}

void WireRecorder::close() {
  if (!thread_.joinable()) return;
  stop_ = true;
  thread_.join();
  std::map<std::string, std::string> lost;
  for (const auto& [topic, count] : status().lost) lost[topic] = std::to_string(count);
  if (!lost.empty()) recorder_.add_metadata("lost", lost);
  recorder_.close();
}

void WireRecorder::work() {
  for (bool is_last = false; !is_last;) {
    const bool is_stopping = stop_;
    if (options_.use_sim_time) hear_clock();
    look_around();
    take_queued();
    for (auto& [guid, source] : sources_) settle(source);
    is_last = is_stopping && held_bytes_ == 0;  // who has just come is still waited for
    report(steady_clock::now());
    if (!is_last) std::this_thread::sleep_for(kPeriod);
  }
}

/// Who is there, which node that is, and which topics are new.
void WireRecorder::look_around() {
  if (options_.use_sim_time && clock_.empty()) return;
  const bool has_names = directory_.update();
  if (!has_names && participant_.endpoint_changes() == known_changes_) return;
  known_changes_ = participant_.endpoint_changes();
  const std::vector<dds::Endpoint> endpoints = participant_.endpoints();
  std::map<std::string, std::set<std::string>> nodes;
  for (const dds::Endpoint& e : endpoints) nodes[e.topic].insert(directory_.node_of(e.guid));
  for (const dds::Endpoint& e : endpoints) {
    if (!e.is_writer || is_own(e.guid, participant_.guid()) || !e.topic.starts_with("rt/")) continue;
    const std::string topic = ros_topic(e.topic);
    if (topic_name_rule(topic) || !choice_.wants(topic, nodes[e.topic]))
      continue;  // any DDS program may be there
    auto known = sources_.find(e.guid);
    if (known == sources_.end()) {
      known = sources_.emplace(e.guid, make_source(topic, ros_type(e.type), type_hash_in(e.user_data), e.qos))
                  .first;
      open_ear(e);
    }
    if (known->second.node.empty()) known->second.node = writer_name(directory_.node_of(e.guid));
  }
}

void WireRecorder::open_ear(const dds::Endpoint& writer) {
  const std::string topic = ros_topic(writer.topic);
  auto& ear = ears_[{topic, writer.type, writer.qos.reliability, writer.qos.durability}];
  if (ear) return;
  ear = std::make_unique<Ear>();
  ear->topic = topic;
  ear->type = ros_type(writer.type);
  ear->offer = writer.qos;
  const Qos qos{.reliability = writer.qos.reliability, .durability = writer.qos.durability, .depth = kDepth};
  try {
    ear->reader = participant_.create_reader(
        {.topic = writer.topic, .type = writer.type, .qos = qos, .user_data = writer.user_data},
        [this, one = ear.get()] {
          if (one->is_queued.exchange(true)) return;
          const std::lock_guard lock(queue_mutex_);
          queue_.push_back(one);
        });
  } catch (const std::runtime_error& error) {
    if (refused_.insert(topic).second) std::cerr << "not recorded: " << error.what() << "\n";
    return;
  }
  announcement_.add(*ear->reader);
  announcement_.publish();
}

WireRecorder::Source WireRecorder::make_source(const std::string& topic, const std::string& type,
                                               const std::string& type_hash, const Qos& offer) {
  Source source{
      .topic = topic, .type = type, .type_hash = type_hash, .offer = offer, .seen = steady_clock::now()};
  source.offer.depth = 0;  // discovery does not tell it
  // Packages change from one distribution to the next: a type of another hash is not ours, whatever its name.
  const TypeDescription* ours = find_type(type, type_hash);
  if (ours == nullptr) return source;
  source.description = ours;
  source.has_stamp = bag::begins_with_stamp(*ours);
  source.type_hash = ours->type_hash;
  return source;
}

WireRecorder::Source& WireRecorder::source_of(const dds::Guid& writer, const Ear& ear) {
  if (!sources_.contains(writer)) look_around();
  const auto known = sources_.find(writer);
  if (known != sources_.end()) return known->second;
  // It came and went between two looks.
  return sources_.emplace(writer, make_source(ear.topic, ear.type, {}, ear.offer)).first->second;
}

void WireRecorder::take_queued() {
  std::vector<Ear*> due;
  for (;;) {
    {
      const std::lock_guard lock(queue_mutex_);
      due.swap(queue_);
    }
    if (due.empty()) return;
    for (Ear* ear : due) {
      ear->is_queued = false;  // before the take: a sample that arrives from now on queues it again
      if (!take_some(*ear) || ear->is_queued.exchange(true)) continue;
      const std::lock_guard lock(queue_mutex_);
      queue_.push_back(ear);
    }
    due.clear();
  }
}

/// False when nothing is left.
bool WireRecorder::take_some(Ear& ear) {
  for (int i = 0; i < kMaxAtOnce; ++i) {
    if (!ear.reader->take(sample_)) return false;
    if (!is_own(sample_.writer, participant_.guid())) take(ear, sample_);
  }
  return true;
}

void WireRecorder::take(const Ear& ear, const dds::Sample& sample) {
  Source& source = source_of(sample.writer, ear);
  const bool by_own =
      ear.offer.reliability == source.offer.reliability && ear.offer.durability == source.offer.durability;
  const std::uint64_t lost = source.intake.lost();
  const bool is_new = source.intake.accept(sample.sequence, by_own);
  if (source.intake.lost() > lost) {
    const std::lock_guard lock(status_mutex_);
    lost_[source.topic] += source.intake.lost() - lost;
  }
  if (!is_new) return;
  if (options_.use_sim_time) hear_clock();  // what came before this sample is there by now
  bag::BytesView cdr = sample.cdr;
  if (source.description != nullptr) {
    // DDS pads; a message of a type that is known ends where it ends.
    cdr = cdr.first(message_size(*source.description, cdr).value_or(cdr.size()));
  }
  if (source.bag_topic) {
    record(source, sample.received, sample.sent, cdr);
    return;
  }
  held_bytes_ += cdr.size();
  source.held.push_back({sample.received, sample.sent, {cdr.begin(), cdr.end()}});
}

/// Gives the source its place in the bag once its node is known, or nobody has named one for long enough.
void WireRecorder::settle(Source& source) {
  if (source.bag_topic || source.held.empty()) return;
  const bool is_long = held_bytes_ > kMaxHeld || steady_clock::now() - source.seen > kLongestUnnamed;
  if (source.node.empty() && !is_long) return;
  const auto [entry, is_new] = bag_topics_.emplace(std::tuple(source.topic, source.type, source.node), 0);
  if (is_new) {
    bag::BagTopic topic{.name = source.topic,
                        .type = source.type,
                        .writer = source.node,
                        .offered_qos_profiles = bag::to_qos_text({source.offer}),
                        .type_hash = source.type_hash,
                        .schema_encoding = source.description == nullptr ? "unknown" : "ros2msg"};
    if (source.description != nullptr) topic.schema_text = bag::schema_text(*source.description);
    entry->second = recorder_.add_topic(topic);
    const std::lock_guard lock(status_mutex_);
    recorded_topics_.insert(source.topic);
  }
  source.bag_topic = entry->second;
  for (const Held& sample : std::exchange(source.held, {})) {
    held_bytes_ -= sample.cdr.size();
    record(source, sample.received, sample.sent, sample.cdr);
  }
}

void WireRecorder::record(const Source& source, Time received, Time sent, bag::BytesView cdr) {
  const Time log = log_time(received);
  Time publish = options_.use_sim_time || sent == Time{} ? log : sent;
  if (source.has_stamp) publish = bag::stamp_of(cdr).value_or(publish);
  recorder_.record(*source.bag_topic, log, publish, cdr);
}

void WireRecorder::hear_clock() {
  rosgraph_msgs::msg::Clock message;
  while (clock_reader_->take(clock_sample_)) {
    if (deserialize(clock_sample_.cdr, message)) clock_[clock_sample_.received] = from_stamp(message.clock());
  }
  while (clock_.size() > kMaxClockSteps) clock_.erase(clock_.begin());
}

Time WireRecorder::log_time(Time received) const {
  if (!options_.use_sim_time) return received;
  const auto after = clock_.upper_bound(received);
  return after == clock_.begin() ? after->second : std::prev(after)->second;
}

void WireRecorder::report(steady_clock::time_point now) {
  if (now - reported_ < kReportPeriod) return;
  reported_ = now;
  const WireRecorderStatus all = status();
  diagnostic_msgs::msg::DiagnosticStatus report;
  report.name(kNodeName);
  report.message("recording");
  add_value(report, "messages", std::to_string(all.bag.recorded));
  add_value(report, "bytes", std::to_string(all.bag.size));
  for (const auto& [topic, count] : all.bag.dropped)
    add_value(report, "dropped " + topic, std::to_string(count));
  for (const auto& [topic, count] : all.lost) add_value(report, "lost " + topic, std::to_string(count));
  if (!all.bag.dropped.empty() || !all.lost.empty()) {
    report.level(1);
    report.message("messages are missing in the recording");
  }
  if (!all.bag.error.empty()) {
    report.level(2);
    report.message("the recording ended early: " + all.bag.error);
  }
  diagnostic_msgs::msg::DiagnosticArray message;
  const auto time = std::chrono::system_clock::now().time_since_epoch();
  message.header().stamp(to_stamp({std::chrono::duration_cast<std::chrono::nanoseconds>(time).count()}));
  message.status().push_back(std::move(report));
  std::vector<std::uint8_t> cdr;
  serialize(message, cdr);
  diagnostics_->write(cdr);
}

}  // namespace bw::record
