// Keeps the last seconds of a run in memory, and writes them, and what follows, when something happens: each
// time a bag of its own. A message costs the lane that sends it one copy; events are looked for, and bags
// written, on a thread of its own. In lock-step all of it happens on the caller's thread, and equal runs give
// equal bags.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "runtime/host/sample_tap.hpp"
#include "runtime/recording/bag/bag_writer.hpp"
#include "runtime/recording/bag/event_watch.hpp"
#include "runtime/recording/bag/snapshot_ring.hpp"

namespace bw::bag {

/// What one must know to make use of a bag of a run.
struct BagDescription {
  struct Attachment {
    std::string name;
    std::string media_type;
    std::string content;
  };
  std::vector<Attachment> attachments;
  std::map<std::string, std::map<std::string, std::string>> metadata;
};

struct FlightRecorderOptions {
  SnapshotRingOptions ring;                         ///< what is kept
  Duration after = Duration::milliseconds(30'000);  ///< written behind the last event
  std::int64_t most = 20;                           ///< snapshots; later events are counted only
  std::filesystem::path folder;                     ///< of the snapshots, made with the first one
  std::vector<Event> events;
  bool waits = false;  ///< lock-step: no thread of its own
  BagWriterOptions writer;
  /// Of an event's time: the first part of its bag's name.
  std::function<std::string(Time)> name_of;
};

struct FlightRecorderStatus {
  Duration kept;                 ///< in memory now
  std::size_t memory = 0;        ///< [bytes]
  std::vector<std::string> log;  ///< what happened so far, in sentences
  std::size_t snapshots = 0;
  std::uint64_t lost = 0;       ///< messages that were to be written, and had to make room first
  std::uint64_t oversized = 0;  ///< messages larger than the memory
  std::uint64_t unwritten = 0;  ///< events behind the last snapshot allowed
  std::string error;            ///< of the last snapshot; empty: none
};

class FlightRecorder final : public SampleTap {
 public:
  explicit FlightRecorder(FlightRecorderOptions options);
  /// close()
  ~FlightRecorder() override;

  /// For every snapshot. Before the run.
  void describe(BagDescription description) { description_ = std::move(description); }
  /// An event that no message tells, at the newest message there is. From any thread.
  void trigger(const std::string& name);

  void connect(const std::vector<const OutputEnd*>& outputs) override;
  void on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) override;
  /// As RunRecorder.
  [[nodiscard]] bool wants_everything() const override { return false; }

  /// Ends the snapshot that is being written.
  void close();
  [[nodiscard]] FlightRecorderStatus status() const;
  /// Names of the events that messages told since the last call; no more than a hundred are kept for it.
  [[nodiscard]] std::vector<std::string> take_events();

 private:
  struct Topic {
    std::size_t number = 0;
    bool has_stamp = false;
  };
  /// What is being written.
  struct Snapshot {
    std::unique_ptr<BagWriter> writer;
    Time event;
    Time until;
    std::string events;  ///< contact at 12.340, ...
    std::size_t event_count = 1;
    std::uint64_t lost_before = 0;
  };

  void run();
  void pump();
  void take(const KeptMessage& message, SnapshotRing::Cursor behind);
  void happened(const std::string& name, const std::string& topic, Time time, SnapshotRing::Cursor behind);
  void begin(const std::string& name, const std::string& topic, Time time, SnapshotRing::Cursor behind);
  void write_past(Time start, SnapshotRing::Cursor behind);
  void write_latched(std::map<std::size_t, std::deque<SnapshotRing::Latched>>& latched, Time time);
  void end();
  template <class Action>
  void on_disk(Action action);
  void say(std::string sentence);

  const FlightRecorderOptions options_;
  BagDescription description_;
  std::vector<BagTopic> topics_;
  std::map<const OutputEnd*, Topic> numbers_;

  // Of the thread that writes.
  EventWatch watch_;
  SnapshotRing::Cursor next_;
  std::optional<Snapshot> snapshot_;
  Time newest_;

  mutable std::mutex mutex_;  ///< guards what follows
  std::condition_variable wake_;
  SnapshotRing ring_;
  std::vector<std::string> triggers_;
  std::vector<std::string> events_;
  FlightRecorderStatus status_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace bw::bag
