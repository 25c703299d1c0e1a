// Records topics of a running ROS 2 system, types it knows and types it does not, into a bag. Topics that
// appear while it records are joined. It is a node of its own, `bandwagon_recorder`, and tells /diagnostics
// how it is doing.
//
// log_time is when a sample arrived here (system clock, or /clock), publish_time its own stamp, or when it
// was sent.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/recording/bag/recorder.hpp"
#include "runtime/recording/record/topic_choice.hpp"
#include "runtime/recording/record/writer_intake.hpp"
#include "runtime/ros/node_announcement.hpp"
#include "runtime/ros/node_directory.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::record {

struct WireRecorderOptions {
  TopicChoiceOptions choice;
  dds::Network network;
  bool use_sim_time = false;  ///< log_time from /clock; recording begins with its first message
  bag::RecorderOptions recorder{.queue_size = std::size_t{100} << 20};
};

struct WireRecorderStatus {
  bag::RecorderStatus bag;
  std::map<std::string, std::uint64_t> lost;  ///< messages by topic that were sent and did not arrive
  std::size_t topics = 0;                     ///< with at least one message
};

class WireRecorder {
 public:
  /// Begins to record. Throws as bag::BagWriter, TopicChoice and dds::Participant do.
  WireRecorder(const std::filesystem::path& path, WireRecorderOptions options);
  /// close(), without a word about what fails then.
  ~WireRecorder();
  WireRecorder(const WireRecorder&) = delete;
  WireRecorder& operator=(const WireRecorder&) = delete;

  /// From any thread.
  [[nodiscard]] WireRecorderStatus status() const;
  /// Ends it. What was lost on the wire becomes the metadata record `lost`, what the disk was too slow for
  /// `dropped`.
  void close();

 private:
  /// A reader of one topic for one quality of service.
  struct Ear {
    std::string topic;  ///< ROS name
    std::string type;   ///< ROS name
    Qos offer;          ///< of the writers that it is made for
    std::atomic<bool> is_queued = false;
    std::unique_ptr<dds::Reader> reader;
  };
  struct Held {
    Time received;
    Time sent;
    std::vector<std::uint8_t> cdr;
  };
  /// A writer of others.
  struct Source {
    std::string topic;
    std::string type;
    std::string type_hash;
    Qos offer;
    std::string node;  ///< empty until it is known
    std::chrono::steady_clock::time_point seen;
    WriterIntake intake;
    const TypeDescription* description = nullptr;  ///< nothing for a type that is not ours
    bool has_stamp = false;
    std::optional<std::size_t> bag_topic;
    std::vector<Held> held;  ///< until the node is known, or has not been for too long
  };

  void work();
  void look_around();
  void open_ear(const dds::Endpoint& writer);
  Source& source_of(const dds::Guid& writer, const Ear& ear);
  Source make_source(const std::string& topic, const std::string& type, const std::string& type_hash,
                     const Qos& offer);
  bool take_some(Ear& ear);
  void take_queued();
  void take(const Ear& ear, const dds::Sample& sample);
  void settle(Source& source);
  void record(const Source& source, Time received, Time sent, bag::BytesView cdr);
  void hear_clock();
  Time log_time(Time received) const;
  void report(std::chrono::steady_clock::time_point now);

  const WireRecorderOptions options_;
  const TopicChoice choice_;
  bag::Recorder recorder_;
  dds::Participant participant_;
  NodeDirectory directory_;
  NodeAnnouncement announcement_;
  std::unique_ptr<dds::Writer> diagnostics_;
  std::unique_ptr<dds::Reader> clock_reader_;

  std::mutex queue_mutex_;
  std::vector<Ear*> queue_;  ///< with samples to take

  // Of the recording thread alone.
  std::uint64_t known_changes_ = ~std::uint64_t{0};
  std::map<std::tuple<std::string, std::string, Reliability, Durability>, std::unique_ptr<Ear>> ears_;
  std::set<std::string> refused_;  ///< topics with a second type, said once
  std::map<dds::Guid, Source> sources_;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> bag_topics_;
  std::size_t held_bytes_ = 0;
  std::map<Time, Time> clock_;  ///< when /clock said what
  dds::Sample sample_;
  dds::Sample clock_sample_;
  std::chrono::steady_clock::time_point reported_;

  mutable std::mutex status_mutex_;
  std::map<std::string, std::uint64_t> lost_;
  std::set<std::string> recorded_topics_;
  std::string failure_;  ///< what ended the thread

  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace bw::record
