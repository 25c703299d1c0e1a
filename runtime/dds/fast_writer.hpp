// A writer on Fast DDS that knows its readers.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

#include "runtime/dds/discovery_listener.hpp"
#include "runtime/dds/raw_type.hpp"

namespace bw::dds {

class FastWriter final : public Writer, private efd::DataWriterListener {
 public:
  FastWriter(efd::Publisher* publisher, std::function<void()> on_match, DiscoveryListener& discovery)
      : publisher_(publisher), on_match_(std::move(on_match)), discovery_(discovery) {}
  ~FastWriter() override {
    if (writer_ == nullptr) return;
    discovery_.remove_local(guid());
    writer_->set_listener(nullptr);
    publisher_->delete_datawriter(writer_);
  }
  FastWriter(const FastWriter&) = delete;
  FastWriter& operator=(const FastWriter&) = delete;

  void open(efd::Topic* topic, const efd::DataWriterQos& qos) {
    writer_ = publisher_->create_datawriter(topic, qos, this, efd::StatusMask::publication_matched());
    if (writer_ == nullptr) throw std::runtime_error("DDS refuses a writer on " + topic->get_name());
  }
  bool write(std::span<const std::uint8_t> cdr) override {
    RawSample sample{.outgoing = cdr, .incoming = {}};
    return fast_dds::write(*writer_, &sample);
  }
  std::optional<SampleIdentity> write_related(std::span<const std::uint8_t> cdr,
                                              const SampleIdentity& related) override {
    RawSample sample{.outgoing = cdr, .incoming = {}};
    rtps::WriteParams params;
    params.related_sample_identity().writer_guid(to_rtps(related.guid));
    if (related.sequence != 0) {
      params.related_sample_identity().sequence_number(
          rtps::SequenceNumber_t(static_cast<std::uint64_t>(related.sequence)));
    }
    if (!fast_dds::write(*writer_, &sample, params)) return std::nullopt;
    return to_identity(params.sample_identity());
  }
  Guid guid() const override { return to_guid(writer_->guid()); }
  int matched_readers() const override { return matched_count_; }
  bool is_matched(const Guid& reader) const override {
    const std::lock_guard lock(mutex_);
    return matched_.contains(reader);
  }
  bool wait_until_received(Duration limit) override {
    return fast_dds::is_ok(writer_->wait_for_acknowledgments(to_duration(limit)));
  }

 private:
  void on_publication_matched(efd::DataWriter*, const efd::PublicationMatchedStatus& status) override {
    const Guid reader = to_guid(rtps::iHandle2GUID(status.last_subscription_handle));
    {
      const std::lock_guard lock(mutex_);
      if (status.current_count_change > 0) {
        matched_.insert(reader);
      } else {
        matched_.erase(reader);
      }
      matched_count_ = static_cast<int>(matched_.size());
    }
    if (on_match_) on_match_();
  }

  efd::Publisher* publisher_;
  std::function<void()> on_match_;
  DiscoveryListener& discovery_;
  mutable std::mutex mutex_;
  std::set<Guid> matched_;
  std::atomic<int> matched_count_ = 0;
  efd::DataWriter* writer_ = nullptr;
};

}  // namespace bw::dds
