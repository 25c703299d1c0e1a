#include "runtime/recording/bag/recorder.hpp"

#include <chrono>
#include <utility>

#include <time.h>

#include "runtime/thrown.hpp"

namespace bw::bag {
namespace {

constexpr std::chrono::milliseconds kPeriod(100);  // between looks at the queue
// A kill takes what waits in the queue and in the open chunk: kPeriod + kFlushPeriod, and the time to write
// them.
constexpr std::chrono::milliseconds kFlushPeriod(500);
// A power cut takes also what came since the last sync.
constexpr std::chrono::milliseconds kSyncPeriod(1000);

/// Of the calling thread.
Duration cpu_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return Duration{time.tv_sec * 1'000'000'000 + time.tv_nsec};
}

}  // namespace

Recorder::Recorder(const std::filesystem::path& path, RecorderOptions options)
    : options_(std::move(options)),
      sync_(options_.waits ? nullptr
                           : std::make_unique<SyncThread>([this](const std::string& error) { fail(error); })),
      writer_(path, writer_options()) {
  if (options_.waits) return;
  thread_ = std::thread([this] {
    try {
      run();
    } catch (...) {
      fail(thrown_text());
    }
  });
}

Recorder::~Recorder() { close(); }

BagWriterOptions Recorder::writer_options() {
  BagWriterOptions writer = options_.writer;
  if (sync_) writer.sync = [this](std::shared_ptr<ByteSink> file) { sync_->ask(std::move(file)); };
  return writer;
}

void Recorder::fail(const std::string& error) {
  const std::lock_guard lock(mutex_);
  if (error_.empty()) error_ = error;
}

/// Runs what touches the disk. Its failure is the end of the recording, and said in the status.
template <class Action>
void Recorder::on_disk(Action action) {
  {
    const std::lock_guard lock(mutex_);
    if (!error_.empty()) return;
  }
  std::string error;
  try {
    action();
  } catch (...) {
    error = thrown_text();
  }
  const std::lock_guard lock(mutex_);
  if (error_.empty()) error_ = std::move(error);
  size_ = writer_.size();
}

std::size_t Recorder::add_topic(const BagTopic& topic) {
  const std::lock_guard writer_lock(writer_mutex_);
  std::size_t number = 0;
  on_disk([&] { number = writer_.add_topic(topic); });
  const std::lock_guard lock(mutex_);
  topic_names_.push_back(topic.name);
  dropped_.push_back(0);
  return topic_names_.size() - 1;
}

void Recorder::attach(const std::string& name, const std::string& media_type, std::string_view content,
                      Time now) {
  const std::lock_guard writer_lock(writer_mutex_);
  on_disk([&] { writer_.attach(name, media_type, content, now); });
}

void Recorder::add_metadata(const std::string& name, const std::map<std::string, std::string>& entries) {
  const std::lock_guard writer_lock(writer_mutex_);
  on_disk([&] { writer_.add_metadata(name, entries); });
}

void Recorder::record(std::size_t topic, Time log_time, Time publish_time, BytesView data) {
  if (options_.waits) {
    const std::lock_guard writer_lock(writer_mutex_);
    on_disk([&] { writer_.write(topic, log_time, publish_time, data); });
    const std::lock_guard lock(mutex_);
    error_.empty() ? ++recorded_ : ++dropped_[topic];
    return;
  }
  const std::lock_guard lock(mutex_);
  if (!error_.empty() || closing_ || queue_.bytes.size() + data.size() > options_.queue_size) {
    ++dropped_[topic];
    return;
  }
  queue_.entries.push_back({topic, log_time, publish_time, data.size()});
  queue_.bytes.insert(queue_.bytes.end(), data.begin(), data.end());
  ++recorded_;
}

void Recorder::write(const Queue& queue) {
  std::size_t offset = 0;
  std::size_t written = 0;
  const std::lock_guard writer_lock(writer_mutex_);
  on_disk([&] {
    for (const Entry& entry : queue.entries) {
      writer_.write(entry.topic, entry.log_time, entry.publish_time,
                    BytesView(queue.bytes).subspan(offset, entry.size));
      offset += entry.size;
      ++written;
    }
  });
  const std::lock_guard lock(mutex_);
  for (std::size_t i = written; i < queue.entries.size(); ++i) {
    ++dropped_[queue.entries[i].topic];
    --recorded_;
  }
}

void Recorder::run() {
  Queue taken;
  auto flushed_at = std::chrono::steady_clock::now();
  auto synced_at = flushed_at;
  std::uint64_t flushed = 0;
  bool is_last = false;
  while (!is_last) {
    {
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, kPeriod, [this] { return closing_; });
      is_last = closing_;
      std::swap(taken, queue_);
    }
    write(taken);
    taken.entries.clear();
    taken.bytes.clear();
    const auto now = std::chrono::steady_clock::now();
    if (now - flushed_at >= kFlushPeriod) {
      flushed_at = now;
      const bool is_due = now - synced_at >= kSyncPeriod;
      if (is_due) synced_at = now;
      const std::lock_guard writer_lock(writer_mutex_);
      on_disk([&] {
        writer_.flush();
        flushed = writer_.message_count();
        if (is_due) sync_->ask(writer_.sink());
      });
    }
    const std::lock_guard lock(mutex_);
    flushed_ = flushed;
    cpu_time_ = cpu_time();
  }
}

void Recorder::close() {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(closing_, true)) return;
    wake_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
  std::map<std::string, std::string> dropped;
  for (const auto& [topic, count] : status().dropped) dropped[topic] = std::to_string(count);
  const std::lock_guard writer_lock(writer_mutex_);
  on_disk([&] {
    if (!dropped.empty()) writer_.add_metadata("dropped", dropped);
    writer_.close();
  });
  if (sync_) sync_->finish();
}

RecorderStatus Recorder::status() const {
  const std::lock_guard lock(mutex_);
  RecorderStatus status{.recorded = recorded_,
                        .flushed = flushed_,
                        .dropped = {},
                        .size = size_,
                        .error = error_,
                        .cpu_time = cpu_time_};
  for (std::size_t i = 0; i < dropped_.size(); ++i) {
    if (dropped_[i] > 0) status.dropped[topic_names_[i]] += dropped_[i];
  }
  return status;
}

}  // namespace bw::bag
