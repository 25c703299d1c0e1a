// Records messages without ever holding up who sends them: they are copied into a bounded queue, and a thread
// of its own writes them. What finds the queue full is dropped and counted, by topic. A disk that fails ends
// the recording, not the drive. A kill of the program costs the last second, a power cut the last two.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "runtime/recording/bag/bag_writer.hpp"
#include "runtime/recording/bag/sync_thread.hpp"

namespace bw::bag {

struct RecorderOptions {
  BagWriterOptions writer;
  /// Waits for the disk instead of dropping, on the caller's thread: for runs in virtual time.
  bool waits = false;
  std::size_t queue_size = std::size_t{16} << 20;  ///< of messages that wait to be written [bytes]
};

struct RecorderStatus {
  std::uint64_t recorded = 0;                    ///< messages written, or waiting to be
  std::uint64_t flushed = 0;                     ///< of them, those that survive a kill
  std::map<std::string, std::uint64_t> dropped;  ///< messages by topic
  std::uint64_t size = 0;                        ///< of the recording [bytes]
  std::string error;                             ///< not empty: nothing is written any more
  Duration cpu_time;                             ///< of the thread that writes
};

class Recorder {
 public:
  /// Throws as BagWriter does.
  Recorder(const std::filesystem::path& path, RecorderOptions options);
  /// close(), without a word about what fails then.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // From any thread.
  std::size_t add_topic(const BagTopic& topic);
  void record(std::size_t topic, Time log_time, Time publish_time, BytesView data);
  void attach(const std::string& name, const std::string& media_type, std::string_view content, Time now);
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& entries);
  [[nodiscard]] RecorderStatus status() const;

  /// Writes what waits, the counts of what was dropped (metadata record `dropped`), and the end. The status
  /// after it is the last one.
  void close();

 private:
  /// A message in the queue; its bytes lie one after the other.
  struct Entry {
    std::size_t topic = 0;
    Time log_time;
    Time publish_time;
    std::size_t size = 0;
  };
  struct Queue {
    std::vector<Entry> entries;
    Bytes bytes;
  };

  template <class Action>
  void on_disk(Action action);
  void write(const Queue& queue);
  void run();

  [[nodiscard]] BagWriterOptions writer_options();
  void fail(const std::string& error);

  const RecorderOptions options_;
  std::unique_ptr<SyncThread> sync_;  ///< none where the caller waits
  mutable std::mutex writer_mutex_;   ///< taken before mutex_ where both are
  BagWriter writer_;

  mutable std::mutex mutex_;  ///< guards what follows
  std::condition_variable wake_;
  Queue queue_;
  std::vector<std::string> topic_names_;
  std::vector<std::uint64_t> dropped_;  ///< by topic
  std::uint64_t recorded_ = 0;
  std::uint64_t flushed_ = 0;
  std::uint64_t size_ = 0;
  std::string error_;
  Duration cpu_time_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace bw::bag
