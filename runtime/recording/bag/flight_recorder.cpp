#include "runtime/recording/bag/flight_recorder.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "runtime/recording/bag/message_stamp.hpp"
#include "runtime/recording/bag/output_topic.hpp"
#include "runtime/recording/bag/qos_text.hpp"
#include "runtime/thrown.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::bag {
namespace {

constexpr std::chrono::milliseconds kPeriod(100);       // between looks at what came
constexpr std::chrono::milliseconds kSyncPeriod(1000);  // of a snapshot that is being written
constexpr std::size_t kMaxEvents = 100;                 // that are told by name

/// The first name of this form that is free.
std::filesystem::path free_path(const std::filesystem::path& wanted) {
  std::filesystem::path path = wanted;
  for (int i = 2; std::filesystem::exists(path); ++i) path = wanted.string() + "_" + std::to_string(i);
  return path;
}

/// A topic's name as a part of a file's: /near/miss becomes near_miss.
std::string file_part(const std::string& name) {
  std::string part = name.starts_with('/') ? name.substr(1) : name;
  std::ranges::replace_if(
      part, [](char c) { return !(std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-'); }, '_');
  return part;
}

std::string time_text(Time time) { return fmt::format("{:.3f}", time.to_seconds()); }

}  // namespace

FlightRecorder::FlightRecorder(FlightRecorderOptions options)
    : options_(std::move(options)), watch_(options_.events), ring_(options_.ring) {}

FlightRecorder::~FlightRecorder() { close(); }

void FlightRecorder::connect(const std::vector<const OutputEnd*>& outputs) {
  for (const OutputEnd* output : outputs) {
    const TypeDescription* type = find_type(output->type.ros_name, output->type.type_hash);
    topics_.push_back(topic_of(*output));
    watch_.add_topic(output->topic, type);
    numbers_[output] = {ring_.add_topic(latched_depth({output->qos})),
                        type != nullptr && begins_with_stamp(*type)};
  }
  if (!options_.waits) thread_ = std::thread([this] { on_disk([this] { run(); }); });
}

void FlightRecorder::on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) {
  const Topic& topic = numbers_.at(&output);
  const Time stamp = topic.has_stamp ? stamp_of(cdr).value_or(now) : now;
  {
    const std::lock_guard lock(mutex_);
    if (closing_) return;
    if (!ring_.add({.topic = topic.number, .log_time = now, .publish_time = stamp, .data = cdr}))
      ++status_.oversized;
  }
  if (options_.waits) pump();
}

void FlightRecorder::trigger(const std::string& name) {
  const std::lock_guard lock(mutex_);
  triggers_.push_back(name);
  wake_.notify_one();
}

void FlightRecorder::run() {
  auto synced = std::chrono::steady_clock::now();
  bool is_last = false;
  while (!is_last) {
    {
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, kPeriod, [this] { return closing_ || !triggers_.empty(); });
      is_last = closing_;
    }
    pump();
    const auto now = std::chrono::steady_clock::now();
    if (!snapshot_ || now - synced < kSyncPeriod) continue;
    synced = now;
    on_disk([this] {
      snapshot_->writer->flush();
      snapshot_->writer->sink()->sync();
    });
  }
}

/// Looks at what came since the last call.
void FlightRecorder::pump() {
  std::vector<std::string> triggers;
  {
    const std::lock_guard lock(mutex_);
    std::swap(triggers, triggers_);
  }
  while (true) {
    SnapshotRing::Stretch stretch;
    SnapshotRing::Cursor behind;
    {
      const std::lock_guard lock(mutex_);
      std::uint64_t lost = 0;
      behind = next_;
      stretch = ring_.read(next_, lost);
      behind.message += lost;
      if (snapshot_) status_.lost += lost;
      status_.memory = ring_.memory();
      status_.kept = ring_.span();
    }
    bool is_empty = true;
    for (KeptMessage message; stretch.next(message); is_empty = false) {
      ++behind.message;
      take(message, behind);
    }
    if (is_empty) break;
  }
  for (const std::string& name : triggers) happened(name, "", newest_, next_);
}

void FlightRecorder::take(const KeptMessage& message, SnapshotRing::Cursor behind) {
  newest_ = std::max(newest_, message.log_time);
  if (snapshot_ && message.log_time > snapshot_->until) end();
  if (snapshot_) {
    on_disk([&] {
      snapshot_->writer->write(message.topic, message.log_time, message.publish_time, message.data);
    });
  }
  if (!watch_.is_watched(message.topic)) return;
  for (const Event* event : watch_.look(message.topic, message.data)) {
    {
      const std::lock_guard lock(mutex_);
      if (events_.size() < kMaxEvents) events_.push_back(event->name);
    }
    happened(event->name, topics_[message.topic].name, message.log_time, behind);
  }
}

void FlightRecorder::happened(const std::string& name, const std::string& topic, Time time,
                              SnapshotRing::Cursor behind) {
  if (snapshot_) {
    snapshot_->until = std::max(snapshot_->until, time + options_.after);
    if (++snapshot_->event_count <= kMaxEvents) snapshot_->events += ", " + name + " at " + time_text(time);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    if (static_cast<std::int64_t>(status_.snapshots) >= options_.most) {
      ++status_.unwritten;
      return;
    }
  }
  begin(name, topic, time, behind);
}

/// Writes the time before the event, up to `behind`.
void FlightRecorder::begin(const std::string& name, const std::string& topic, Time time,
                           SnapshotRing::Cursor behind) {
  snapshot_.emplace(Snapshot{.event = time, .until = time + options_.after});
  snapshot_->events = name + " at " + time_text(time);
  {
    const std::lock_guard lock(mutex_);
    ++status_.snapshots;
    status_.error.clear();
    snapshot_->lost_before = status_.lost;
  }
  on_disk([&] {
    const std::string folder = options_.name_of(time) + "_" + file_part(name);
    snapshot_->writer = std::make_unique<BagWriter>(free_path(options_.folder / folder), options_.writer);
    for (const BagTopic& t : topics_) snapshot_->writer->add_topic(t);
    for (const auto& a : description_.attachments)
      snapshot_->writer->attach(a.name, a.media_type, a.content, time);
    for (const auto& [record, entries] : description_.metadata)
      snapshot_->writer->add_metadata(record, entries);
    snapshot_->writer->add_metadata("snapshot", {{"event", name},
                                                 {"topic", topic},
                                                 {"time", time_text(time)},
                                                 {"keep", fmt::format("{}", options_.ring.keep.to_seconds())},
                                                 {"after", fmt::format("{}", options_.after.to_seconds())}});
  });
  if (!snapshot_) return;
  say(fmt::format("{} at {} s: snapshot {}", name, time_text(time), snapshot_->writer->path().string()));
  write_past(time - options_.ring.keep, behind);
  if (!options_.waits && snapshot_) {
    on_disk([this] {
      snapshot_->writer->flush();
      snapshot_->writer->sink()->sync();
    });
  }
}

void FlightRecorder::write_past(Time start, SnapshotRing::Cursor behind) {
  std::map<std::size_t, std::deque<SnapshotRing::Latched>> latched;
  SnapshotRing::Cursor cursor;
  {
    const std::lock_guard lock(mutex_);
    latched = ring_.latched();
    cursor = ring_.begin();
  }
  bool has_begun = false;
  while (snapshot_ && cursor.message < behind.message) {
    SnapshotRing::Stretch stretch;
    SnapshotRing::Cursor at = cursor;
    {
      const std::lock_guard lock(mutex_);
      std::uint64_t lost = 0;
      stretch = ring_.read(cursor, lost);
      status_.lost += lost;
      at.message += lost;
    }
    for (KeptMessage m; snapshot_ && at.message < behind.message && stretch.next(m); ++at.message) {
      if (m.log_time < start) {
        if (has_begun || ring_.latched_depth(m.topic) == 0) continue;
        auto& kept = latched[m.topic];
        kept.push_back({m.publish_time, {m.data.begin(), m.data.end()}});
        if (kept.size() > ring_.latched_depth(m.topic)) kept.pop_front();
        continue;
      }
      if (!std::exchange(has_begun, true)) write_latched(latched, m.log_time);
      on_disk([&] { snapshot_->writer->write(m.topic, m.log_time, m.publish_time, m.data); });
    }
  }
  const std::lock_guard lock(mutex_);
  std::uint64_t lost = 0;
  SnapshotRing::Cursor again = behind;
  static_cast<void>(ring_.read(again, lost));  // what lies before `behind` is not held any more
}

/// As a player finds them: at the beginning.
void FlightRecorder::write_latched(std::map<std::size_t, std::deque<SnapshotRing::Latched>>& latched,
                                   Time time) {
  for (const auto& [topic, messages] : latched) {
    for (const SnapshotRing::Latched& m : messages) {
      if (!snapshot_) return;
      on_disk([&] { snapshot_->writer->write(topic, time, m.publish_time, m.data); });
    }
  }
}

void FlightRecorder::end() {
  std::uint64_t lost = 0;
  {
    const std::lock_guard lock(mutex_);
    lost = status_.lost - snapshot_->lost_before;
  }
  on_disk([&] {
    BagWriter& writer = *snapshot_->writer;
    writer.add_metadata("snapshot_result", {{"events", snapshot_->events},
                                            {"event_count", std::to_string(snapshot_->event_count)},
                                            {"lost", std::to_string(lost)}});
    writer.close();
    say(fmt::format("snapshot {} has {} messages, {:.1f} MB, {} events", writer.path().string(),
                    writer.message_count(), static_cast<double>(writer.size()) * 1e-6,
                    snapshot_->event_count));
  });
  snapshot_.reset();
}

/// Runs what touches the disk. Its failure ends this snapshot, not the drive, and the next event tries anew.
template <class Action>
void FlightRecorder::on_disk(Action action) {
  try {
    action();
    return;
  } catch (...) {
    const std::string failure = thrown_text();
    {
      const std::lock_guard lock(mutex_);
      status_.error = failure;
    }
    say("the snapshot ended early: " + failure);
  }
  snapshot_.reset();
}

void FlightRecorder::say(std::string sentence) {
  const std::lock_guard lock(mutex_);
  status_.log.push_back(std::move(sentence));
}

void FlightRecorder::close() {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(closing_, true)) return;
    wake_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
  if (snapshot_) end();
}

std::vector<std::string> FlightRecorder::take_events() {
  const std::lock_guard lock(mutex_);
  return std::exchange(events_, {});
}

FlightRecorderStatus FlightRecorder::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

}  // namespace bw::bag
