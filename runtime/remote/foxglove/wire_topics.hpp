// The topics of a domain as channels, and their messages to who has subscribed.
//
// A topic has a reader for each quality of service that is offered on it, while somebody has subscribed and a
// moment longer.
// Messages are checked, cut to their size (DDS pads them) and passed on as they are; of latched ones the last
// of each writer is kept.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/recording/record/writer_intake.hpp"
#include "runtime/remote/foxglove/robot.hpp"
#include "runtime/remote/foxglove/wire_clock.hpp"
#include "runtime/remote/foxglove/wire_link.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::foxglove {

class WireTopics {
 public:
  WireTopics(WireLink& link, WireClock& clock);

  /// What others write.
  void look(const std::vector<dds::Endpoint>& endpoints);
  /// Closes what nobody has wanted for a moment; takes what waited.
  void tick(std::chrono::steady_clock::time_point now);
  /// Something is heard.
  bool is_listening() const { return open_count_ > 0; }

  std::vector<Channel> channels() const;
  void subscribe(std::uint32_t channel);
  void unsubscribe(std::uint32_t channel);
  std::vector<std::pair<Time, SharedBytes>> latched(std::uint32_t channel) const;

 private:
  struct Ear {
    std::uint32_t channel = 0;
    Qos offer;  ///< of the writers that it is made for
    std::atomic<bool> is_queued = false;
    std::unique_ptr<dds::Reader> reader;
  };
  /// A writer of others.
  struct Source {
    std::uint32_t channel = 0;
    Qos offer;
    record::WriterIntake intake;
    std::optional<std::pair<Time, SharedBytes>> last;  ///< latched
  };
  struct Topic {
    Channel channel;
    const TypeDescription* type = nullptr;
    std::string dds_type;
    std::string user_data;
    int subscribers = 0;
    std::chrono::steady_clock::time_point unwanted_since;
    std::vector<std::shared_ptr<Ear>> ears;
    bool is_malformed = false;  ///< said once
  };
  /// What arrived, from DDS threads.
  struct Queue {
    std::mutex mutex;
    std::vector<std::weak_ptr<Ear>> ears;
  };

  std::uint32_t id_of(const std::string& topic, const TypeDescription& type);
  const TypeDescription* type_of(const dds::Endpoint& writer);
  void add_source(const dds::Endpoint& writer, const TypeDescription& type);
  std::vector<std::uint32_t> forget_the_gone(const std::set<dds::Guid>& there);
  void open_ears(Topic& topic);
  void open_ear(Topic& topic, const Qos& offer);
  void close_ears(Topic& topic);
  void take_queued();
  bool take_some(Ear& ear);
  void take(const Ear& ear, const dds::Sample& sample);
  void enqueue(const std::shared_ptr<Ear>& ear);

  WireLink& link_;
  WireClock& clock_;
  std::map<std::pair<std::string, const TypeDescription*>, std::uint32_t> ids_;
  std::map<std::uint32_t, Topic> topics_;
  std::map<std::string, std::uint32_t> channel_of_;  ///< by topic
  std::map<dds::Guid, Source> sources_;
  std::set<std::pair<std::string, std::string>> told_;  ///< topics with types that are not shown
  std::shared_ptr<Queue> queue_ = std::make_shared<Queue>();
  PostedTask taking_;
  dds::Sample sample_;
  std::size_t open_count_ = 0;  ///< of topics with ears
};

}  // namespace bw::foxglove
