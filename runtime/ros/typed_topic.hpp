// Ends of topics by their message types, for programs that are no component of a graph.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/dds/participant.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw {

template <class M>
dds::EndpointOptions typed_end(const std::string& topic, const Qos& qos) {
  using Traits = MessageTraits<M>;
  return {.topic = dds_topic(topic),
          .type = std::string(Traits::dds_name),
          .qos = qos,
          .user_data = user_data_of(std::string(Traits::type_hash)),
          .heartbeat = dds::kPromptHeartbeat};
}

template <class M>
class TopicWriter {
 public:
  TopicWriter(dds::Participant& participant, const std::string& topic, const Qos& qos)
      : writer_(participant.create_writer(typed_end<M>(topic, qos))) {}

  void publish(const M& message) {
    serialize(message, cdr_);
    writer_->write(cdr_);
  }
  int readers() const { return writer_->matched_readers(); }
  /// False when not all readers have everything after `limit`.
  bool flush(Duration limit) { return writer_->wait_until_received(limit); }

 private:
  std::unique_ptr<dds::Writer> writer_;
  std::vector<std::uint8_t> cdr_;
};

template <class M>
class TopicReader {
 public:
  /// Takes whatever QoS is offered, unless `qos` asks for more. `on_news` runs on a DDS thread: it may only
  /// wake somebody.
  TopicReader(
      dds::Participant& participant, const std::string& topic, const Qos& qos = Qos::sensor(),
      std::function<void()> on_news = [] {})
      : reader_(participant.create_reader(typed_end<M>(topic, qos), std::move(on_news))) {}

  /// The oldest message that waits; what is none is left out.
  std::optional<M> take() {
    for (M message; reader_->take(sample_);)
      if (deserialize(sample_.cdr, message)) return message;
    return std::nullopt;
  }
  /// The newest that has come since the last look.
  std::optional<M> take_newest() {
    std::optional<M> newest;
    while (std::optional<M> next = take()) newest = std::move(next);
    return newest;
  }
  int writers() const { return reader_->matched_writers(); }

 private:
  std::unique_ptr<dds::Reader> reader_;
  dds::Sample sample_;
};

}  // namespace bw
