// A reader on Fast DDS. Its listener says that something waits, and nothing more.
#pragma once

#include <functional>
#include <stdexcept>
#include <utility>

#include "runtime/dds/discovery_listener.hpp"
#include "runtime/dds/raw_type.hpp"

namespace bw::dds {

class EnqueueListener final : public efd::DataReaderListener {
 public:
  EnqueueListener(std::function<void()> on_sample, std::function<void()> on_match)
      : on_sample_(std::move(on_sample)), on_match_(std::move(on_match)) {}
  void on_data_available(efd::DataReader*) override { on_sample_(); }
  void on_subscription_matched(efd::DataReader*, const efd::SubscriptionMatchedStatus&) override {
    on_match_();
  }
  efd::StatusMask heard() const {
    efd::StatusMask mask = efd::StatusMask::data_available();
    if (on_match_) mask << efd::StatusMask::subscription_matched();
    return mask;
  }

 private:
  std::function<void()> on_sample_;
  std::function<void()> on_match_;
};

class FastReader final : public Reader {
 public:
  FastReader(efd::Subscriber* subscriber, std::function<void()> on_sample, std::function<void()> on_match,
             DiscoveryListener& discovery)
      : subscriber_(subscriber),
        listener_(std::move(on_sample), std::move(on_match)),
        discovery_(discovery) {}
  ~FastReader() override {
    if (reader_ == nullptr) return;
    discovery_.remove_local(guid());
    reader_->set_listener(nullptr);
    subscriber_->delete_datareader(reader_);
  }
  FastReader(const FastReader&) = delete;
  FastReader& operator=(const FastReader&) = delete;

  void open(efd::Topic* topic, const efd::DataReaderQos& qos) {
    reader_ = subscriber_->create_datareader(topic, qos, &listener_, listener_.heard());
    if (reader_ == nullptr) throw std::runtime_error("DDS refuses a reader on " + topic->get_name());
  }
  bool take(Sample& sample) override {
    efd::SampleInfo info;
    RawSample raw;
    raw.incoming.swap(sample.cdr);  // keeps the capacity from call to call
    while (fast_dds::is_ok(reader_->take_next_sample(&raw, &info))) {
      if (!info.valid_data) continue;
      sample.cdr.swap(raw.incoming);
      sample.writer = to_guid(info.sample_identity.writer_guid());
      sample.sequence = info.sample_identity.sequence_number().to64long();
      sample.related = to_identity(info.related_sample_identity);
      sample.received = to_time(info.reception_timestamp);
      sample.sent = to_time(info.source_timestamp);
      return true;
    }
    return false;
  }
  Guid guid() const override { return to_guid(reader_->guid()); }
  int matched_writers() const override {
    efd::SubscriptionMatchedStatus status;
    reader_->get_subscription_matched_status(status);
    return status.current_count;
  }

 private:
  efd::Subscriber* subscriber_;
  EnqueueListener listener_;
  DiscoveryListener& discovery_;
  efd::DataReader* reader_ = nullptr;
};

}  // namespace bw::dds
