#include "runtime/dds/participant.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include "runtime/dds/loopback_sockets.hpp"
#include "runtime/dds/raw_type.hpp"

namespace bw::dds {

namespace efd = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

bool same_participant(const Guid& a, const Guid& b) {
  constexpr std::size_t kPrefix = 12;
  return std::equal(a.begin(), a.begin() + kPrefix, b.begin());
}

namespace {

Guid to_guid(const rtps::GUID_t& guid) {
  Guid result{};
  std::copy_n(guid.guidPrefix.value, 12, result.begin());
  std::copy_n(guid.entityId.value, 4, result.begin() + 12);
  return result;
}

rtps::GUID_t to_rtps(const Guid& guid) {
  rtps::GUID_t result;
  std::copy_n(guid.begin(), 12, result.guidPrefix.value);
  std::copy_n(guid.begin() + 12, 4, result.entityId.value);
  return result;
}

SampleIdentity to_identity(const rtps::SampleIdentity& identity) {
  if (identity.writer_guid() == rtps::c_Guid_Unknown) return {};
  return {to_guid(identity.writer_guid()), static_cast<std::int64_t>(identity.sequence_number().to64long())};
}

eprosima::fastrtps::Duration_t to_duration(Duration d) {
  return {static_cast<std::int32_t>(d.nanoseconds / 1'000'000'000),
          static_cast<std::uint32_t>(d.nanoseconds % 1'000'000'000)};
}

/// What is no time (a writer need not tell any) becomes 0.
Time to_time(const rtps::Time_t& time) {
  if (time.seconds() <= 0 || time == rtps::c_RTPSTimeInfinite) return {};
  return {std::int64_t{time.seconds()} * 1'000'000'000 + time.nanosec()};
}

void set_user_data(efd::UserDataQosPolicy& policy, const std::string& text) {
  policy.setValue(std::vector<rtps::octet>(text.begin(), text.end()));
}

/// Reader and writer QoS classes share the names but not a base class.
template <class EndpointQos>
void apply(const EndpointOptions& options, EndpointQos& qos) {
  const Qos& q = options.qos;
  qos.reliability().kind = q.reliability == Reliability::reliable ? efd::RELIABLE_RELIABILITY_QOS
                                                                  : efd::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = q.durability == Durability::transient_local ? efd::TRANSIENT_LOCAL_DURABILITY_QOS
                                                                      : efd::VOLATILE_DURABILITY_QOS;
  qos.history().kind = efd::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = q.depth;
  qos.data_sharing().off();
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.resource_limits().allocated_samples = std::min(options.allocated_samples, 100);
  if (q.lifespan) qos.lifespan().duration = to_duration(*q.lifespan);
}

template <class ProxyData>
Endpoint to_endpoint(const ProxyData& data, bool is_writer) {
  Endpoint e;
  e.guid = to_guid(data.guid());
  e.is_writer = is_writer;
  e.topic = data.topicName().to_string();
  e.type = data.typeName().to_string();
  e.qos.reliability = data.m_qos.m_reliability.kind == efd::RELIABLE_RELIABILITY_QOS
                          ? Reliability::reliable
                          : Reliability::best_effort;
  e.qos.durability = data.m_qos.m_durability.kind >= efd::TRANSIENT_LOCAL_DURABILITY_QOS
                         ? Durability::transient_local
                         : Durability::volatile_;
  const eprosima::fastrtps::Duration_t& lifespan = data.m_qos.m_lifespan.duration;
  if (lifespan != eprosima::fastrtps::c_TimeInfinite) e.qos.lifespan = Duration{lifespan.to_ns()};
  const auto& user_data = data.m_qos.m_userData.getValue();
  e.user_data.assign(user_data.begin(), user_data.end());
  e.partitions = data.m_qos.m_partition.getNames();
  return e;
}

void add_peer(rtps::LocatorList_t& peers, const std::string& address) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  locator.port = 0;
  if (!rtps::IPLocator::setIPv4(locator, address)) {
    throw std::runtime_error("ROS_STATIC_PEERS: \"" + address + "\" is not an IPv4 address");
  }
  peers.push_back(locator);
}

efd::DomainParticipantQos participant_qos(const ParticipantOptions& options) {
  constexpr unsigned kPeerPorts = 32;  // participants per host that discovery by unicast tries
  efd::DomainParticipantQos qos = efd::PARTICIPANT_QOS_DEFAULT;
  qos.name(options.name.c_str());
  set_user_data(qos.user_data(), "enclave=" + options.name + ";");
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->maxInitialPeersRange = kPeerPorts;
  udp->receiveBufferSize = options.receive_buffer;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);

  efd::WireProtocolConfigQos& wire = qos.wire_protocol();
  wire.builtin.discovery_config.leaseDuration = {4, 0};
  wire.builtin.discovery_config.leaseDuration_announcementperiod = {1, 0};
  wire.builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  wire.builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  if (options.network.transport == Transport::localhost) {
    rtps::Locator_t loopback;
    loopback.kind = LOCATOR_KIND_UDPv4;
    loopback.port = 0;
    rtps::IPLocator::setIPv4(loopback, "127.0.0.1");
    wire.builtin.metatrafficUnicastLocatorList.push_back(loopback);
    wire.default_unicast_locator_list.push_back(loopback);
    add_peer(wire.builtin.initialPeersList, "127.0.0.1");
  } else if (!options.network.static_peers.empty()) {
    // A peer list replaces the default multicast peer: keep that one too.
    add_peer(wire.builtin.initialPeersList, "239.255.0.1");
    add_peer(wire.builtin.initialPeersList, "127.0.0.1");
    for (const std::string& peer : options.network.static_peers)
      add_peer(wire.builtin.initialPeersList, peer);
  }
  return qos;
}

/// Keeps the table of remote participants and endpoints.
class DiscoveryListener final : public efd::DomainParticipantListener {
 public:
  void on_participant_discovery(efd::DomainParticipant*, rtps::ParticipantDiscoveryInfo&& info) override {
    const Guid guid = to_guid(info.info.m_guid);
    const std::lock_guard lock(mutex_);
    if (info.status == rtps::ParticipantDiscoveryInfo::REMOVED_PARTICIPANT ||
        info.status == rtps::ParticipantDiscoveryInfo::DROPPED_PARTICIPANT) {
      participants_.erase(guid);
      std::erase_if(endpoints_, [&](const auto& item) {
        const bool is_its = std::equal(guid.begin(), guid.begin() + 12, item.first.begin());
        if (is_its) remember(item.second);
        return is_its;
      });
      ++changes_;
    } else {
      participants_[guid] = true;
    }
  }
  void on_subscriber_discovery(efd::DomainParticipant*, rtps::ReaderDiscoveryInfo&& info) override {
    update(to_endpoint(info.info, false), info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER);
  }
  void on_publisher_discovery(efd::DomainParticipant*, rtps::WriterDiscoveryInfo&& info) override {
    update(to_endpoint(info.info, true), info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER);
  }

  void add_local(Endpoint endpoint) {
    endpoint.is_local = true;
    update(endpoint, false);
  }
  void remove_local(const Guid& guid) {
    const std::lock_guard lock(mutex_);
    endpoints_.erase(guid);
    ++changes_;
  }
  std::uint64_t changes() const { return changes_; }
  std::vector<Endpoint> endpoints() const {
    std::vector<Endpoint> all;
    {
      const std::lock_guard lock(mutex_);
      for (const auto& [guid, endpoint] : endpoints_) all.push_back(endpoint);
    }
    std::ranges::sort(all, [](const Endpoint& a, const Endpoint& b) {
      return std::tie(a.topic, a.is_writer, a.guid) < std::tie(b.topic, b.is_writer, b.guid);
    });
    return all;
  }
  std::vector<Endpoint> take_departed() {
    const std::lock_guard lock(mutex_);
    return std::exchange(departed_, {});
  }
  std::vector<Guid> participants() const {
    const std::lock_guard lock(mutex_);
    std::vector<Guid> all;
    for (const auto& [guid, alive] : participants_) all.push_back(guid);
    return all;
  }

 private:
  void update(const Endpoint& endpoint, bool removed) {
    const std::lock_guard lock(mutex_);
    if (removed) {
      if (endpoints_.erase(endpoint.guid) > 0) remember(endpoint);
    } else {
      endpoints_[endpoint.guid] = endpoint;
    }
    ++changes_;
  }
  /// With the mutex held.
  void remember(const Endpoint& endpoint) {
    constexpr std::size_t kMost = 256;
    if (endpoint.is_writer && departed_.size() < kMost) departed_.push_back(endpoint);
  }

  std::atomic<std::uint64_t> changes_ = 0;
  mutable std::mutex mutex_;
  std::map<Guid, bool> participants_;
  std::map<Guid, Endpoint> endpoints_;
  std::vector<Endpoint> departed_;
};

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

}  // namespace

using Partitions = std::vector<std::string>;

struct Participant::Impl {
  DiscoveryListener discovery;
  efd::DomainParticipant* participant = nullptr;
  std::string private_partition;
  Partitions of_writers, of_readers;  ///< where an endpoint names none
  std::mutex mutex;
  std::map<Partitions, efd::Publisher*> publishers;
  std::map<Partitions, efd::Subscriber*> subscribers;
  std::map<std::string, efd::Topic*> topics;

  ~Impl() {
    if (participant == nullptr) return;
    participant->set_listener(nullptr);
    participant->delete_contained_entities();
    efd::DomainParticipantFactory::get_instance()->delete_participant(participant);
  }

  efd::Publisher* publisher(const Partitions& asked) {
    const std::lock_guard lock(mutex);
    const Partitions& partitions = asked.empty() ? of_writers : asked;
    efd::Publisher*& publisher = publishers[partitions];
    if (publisher != nullptr) return publisher;
    efd::PublisherQos qos = efd::PUBLISHER_QOS_DEFAULT;
    for (const std::string& name : partitions) qos.partition().push_back(name.c_str());
    publisher = participant->create_publisher(qos);
    return publisher;
  }
  efd::Subscriber* subscriber(const Partitions& asked) {
    const std::lock_guard lock(mutex);
    const Partitions& partitions = asked.empty() ? of_readers : asked;
    efd::Subscriber*& subscriber = subscribers[partitions];
    if (subscriber != nullptr) return subscriber;
    efd::SubscriberQos qos = efd::SUBSCRIBER_QOS_DEFAULT;
    for (const std::string& name : partitions) qos.partition().push_back(name.c_str());
    subscriber = participant->create_subscriber(qos);
    return subscriber;
  }

  efd::Topic* topic(const EndpointOptions& options) {
    const std::lock_guard lock(mutex);
    efd::Topic*& topic = topics[options.topic];
    if (topic == nullptr) {
      efd::TypeSupport type(new RawType(options.type));
      type.register_type(participant);
      topic = participant->create_topic(options.topic, options.type, efd::TOPIC_QOS_DEFAULT);
      if (topic == nullptr) throw std::runtime_error("DDS refuses the topic " + options.topic);
    }
    if (topic->get_type_name() != options.type) {
      throw std::runtime_error("topic " + options.topic + " carries " + topic->get_type_name() + ", not " +
                               options.type);
    }
    return topic;
  }
};

namespace {

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
    return writer_->write(&sample);
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
    if (!writer_->write(&sample, params)) return std::nullopt;
    return to_identity(params.sample_identity());
  }
  Guid guid() const override { return to_guid(writer_->guid()); }
  int matched_readers() const override { return matched_count_; }
  bool is_matched(const Guid& reader) const override {
    const std::lock_guard lock(mutex_);
    return matched_.contains(reader);
  }
  bool wait_until_received(Duration limit) override {
    return writer_->wait_for_acknowledgments(to_duration(limit)) == ReturnCode_t::RETCODE_OK;
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
    while (reader_->take_next_sample(&raw, &info) == ReturnCode_t::RETCODE_OK) {
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

}  // namespace

Participant::Participant(const ParticipantOptions& options) : impl_(std::make_unique<Impl>()) {
  efd::Log::SetVerbosity(efd::Log::Kind::Error);
  const std::set<int> before = open_datagram_sockets();
  const auto domain = static_cast<efd::DomainId_t>(options.network.domain_id);
  // Created with the listener, so that nothing discovered early is missed.
  impl_->participant = efd::DomainParticipantFactory::get_instance()->create_participant(
      domain, participant_qos(options), &impl_->discovery, efd::StatusMask::none());
  if (impl_->participant == nullptr) {
    throw std::runtime_error("DDS refuses a participant on domain " +
                             std::to_string(options.network.domain_id));
  }
  if (options.network.transport == Transport::localhost) {
    std::set<int> opened = open_datagram_sockets();
    std::erase_if(opened, [&](int descriptor) { return before.contains(descriptor); });
    bind_to_loopback(opened);
  }
  impl_->private_partition = options.private_partition;
  if (!options.private_partition.empty()) {
    impl_->of_writers = {"", options.private_partition};  // "" is the partition of every ordinary reader
    impl_->of_readers = {options.private_partition};
  }
}

Participant::~Participant() = default;

std::unique_ptr<Writer> Participant::create_writer(const EndpointOptions& options,
                                                   std::function<void()> on_match) {
  efd::DataWriterQos qos = efd::DATAWRITER_QOS_DEFAULT;
  apply(options, qos);
  qos.publish_mode().kind = efd::SYNCHRONOUS_PUBLISH_MODE;
  if (options.heartbeat) qos.reliable_writer_qos().times.heartbeatPeriod = to_duration(*options.heartbeat);
  set_user_data(qos.user_data(), options.user_data);
  auto result = std::make_unique<FastWriter>(impl_->publisher(options.partitions), std::move(on_match),
                                             impl_->discovery);
  result->open(impl_->topic(options), qos);
  impl_->discovery.add_local({.guid = result->guid(),
                              .is_writer = true,
                              .topic = options.topic,
                              .type = options.type,
                              .qos = options.qos,
                              .user_data = options.user_data,
                              .partitions = options.partitions});
  return result;
}

std::unique_ptr<Reader> Participant::create_reader(const EndpointOptions& options,
                                                   std::function<void()> on_sample,
                                                   std::function<void()> on_match) {
  efd::DataReaderQos qos = efd::DATAREADER_QOS_DEFAULT;
  apply(options, qos);
  set_user_data(qos.user_data(), options.user_data);
  auto result = std::make_unique<FastReader>(impl_->subscriber(options.partitions), std::move(on_sample),
                                             std::move(on_match), impl_->discovery);
  result->open(impl_->topic(options), qos);
  impl_->discovery.add_local({.guid = result->guid(),
                              .is_writer = false,
                              .topic = options.topic,
                              .type = options.type,
                              .qos = options.qos,
                              .user_data = options.user_data,
                              .partitions = options.partitions});
  return result;
}

Guid Participant::guid() const { return to_guid(impl_->participant->guid()); }

const std::string& Participant::private_partition() const { return impl_->private_partition; }

std::vector<Endpoint> Participant::endpoints() const { return impl_->discovery.endpoints(); }

std::vector<Endpoint> Participant::take_departed() { return impl_->discovery.take_departed(); }

std::uint64_t Participant::endpoint_changes() const { return impl_->discovery.changes(); }

std::vector<Guid> Participant::remote_participants() const { return impl_->discovery.participants(); }

}  // namespace bw::dds
