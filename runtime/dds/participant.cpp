#include "runtime/dds/participant.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>

#include <unistd.h>

#include "runtime/dds/bus.hpp"
#include "runtime/dds/fast_reader.hpp"
#include "runtime/dds/fast_writer.hpp"
#include "runtime/dds/loopback_sockets.hpp"

namespace bw::dds {

bool same_participant(const Guid& a, const Guid& b) {
  constexpr std::size_t kPrefix = 12;
  return std::equal(a.begin(), a.begin() + kPrefix, b.begin());
}

bool same_host(const Guid& a, const Guid& b) {
  constexpr std::array<std::uint8_t, 2> kFastDds = {0x01, 0x0f};
  constexpr std::size_t kVendorAndHost = 4;
  return std::equal(kFastDds.begin(), kFastDds.end(), a.begin()) &&
         std::equal(a.begin(), a.begin() + kVendorAndHost, b.begin());
}

namespace {

void add_peer(rtps::LocatorList_t& peers, const std::string& address) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  locator.port = 0;
  if (!rtps::IPLocator::setIPv4(locator, address)) {
    throw std::runtime_error("ROS_STATIC_PEERS: \"" + address + "\" is not an IPv4 address");
  }
  peers.push_back(locator);
}

// Who comes is answered at once, but may miss it: Fast DDS (2.9 to 2.14) announces itself before it hears.
// The next announcement has to come within the half second in which ROS 2's tools look around.
Duration announcement_period(const Network& network) {
  // Peers by address get a packet on each of their ports, through the network.
  const bool seeks_hosts = network.transport == Transport::lan && !network.static_peers.empty();
  return Duration::milliseconds(seeks_hosts ? 1000 : 200);
}

efd::DomainParticipantQos participant_qos(const ParticipantOptions& options) {
  constexpr unsigned kPeerPorts = 32;  // participants per host that discovery by unicast tries
  efd::DomainParticipantQos qos = efd::PARTICIPANT_QOS_DEFAULT;
  qos.name(options.name.c_str());
  set_user_data(qos.user_data(), "enclave=" + options.name + ";");
  auto udp = std::make_shared<fast_dds::transport::UDPv4TransportDescriptor>();
  udp->maxInitialPeersRange = kPeerPorts;
  udp->receiveBufferSize = options.receive_buffer;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);

  fast_dds::disable_type_propagation(qos);

  efd::WireProtocolConfigQos& wire = qos.wire_protocol();
  wire.builtin.discovery_config.leaseDuration = {4, 0};
  wire.builtin.discovery_config.leaseDuration_announcementperiod =
      to_duration(announcement_period(options.network));
  wire.builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  wire.builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  rtps::Locator_t loopback;
  loopback.kind = LOCATOR_KIND_UDPv4;
  loopback.port = 0;
  rtps::IPLocator::setIPv4(loopback, "127.0.0.1");
  if (options.network.transport == Transport::localhost) {
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

}  // namespace

using Partitions = std::vector<std::string>;

namespace {

/// Whose sockets those are that appear meanwhile: participants of one process come and go one at a time. The
/// kernel binds a socket to a device only once, for a user without rights.
std::mutex& coming_and_going() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

struct Participant::Impl {
  DiscoveryListener discovery;
  efd::DomainParticipant* participant = nullptr;  ///< none: alone
  std::shared_ptr<Bus> bus;                       ///< of what stays in the process, if anything
  std::string private_partition;
  std::mutex mutex;
  std::map<Partitions, efd::Publisher*> publishers;
  std::map<Partitions, efd::Subscriber*> subscribers;
  std::map<std::string, efd::Topic*> topics;

  ~Impl() {
    if (participant == nullptr) return;
    const std::lock_guard alone(coming_and_going());
    participant->set_listener(nullptr);
    participant->delete_contained_entities();
    efd::DomainParticipantFactory::get_instance()->delete_participant(participant);
  }

  void open(const ParticipantOptions& options) {
    efd::Log::SetVerbosity(efd::Log::Kind::Error);
    const std::lock_guard alone(coming_and_going());
    const std::set<int> before = open_datagram_sockets();
    const auto domain = static_cast<efd::DomainId_t>(options.network.domain_id);
    // Created with the listener, so that nothing discovered early is missed.
    participant = efd::DomainParticipantFactory::get_instance()->create_participant(
        domain, participant_qos(options), &discovery, efd::StatusMask::none());
    if (participant == nullptr) {
      throw std::runtime_error("DDS refuses a participant on domain " +
                               std::to_string(options.network.domain_id));
    }
    if (options.network.transport != Transport::localhost) return;
    std::set<int> opened = open_datagram_sockets();
    std::erase_if(opened, [&](int descriptor) { return before.contains(descriptor); });
    bind_to_loopback(opened);
  }

  bool goes_by_bus(const EndpointOptions& options) const {
    return bus && (participant == nullptr || options.partitions.empty() ||
                   std::ranges::find(options.partitions, private_partition) != options.partitions.end());
  }
  /// The end as DDS has it where it goes by the bus, too; nothing: it has none.
  std::optional<EndpointOptions> outside(EndpointOptions options) const {
    if (participant == nullptr) return std::nullopt;
    if (options.partitions.empty()) return options;
    std::erase(options.partitions, private_partition);
    return options.partitions.empty() ? std::nullopt : std::optional(std::move(options));
  }

  efd::Publisher* publisher(const Partitions& partitions) {
    const std::lock_guard lock(mutex);
    efd::Publisher*& publisher = publishers[partitions];
    if (publisher != nullptr) return publisher;
    efd::PublisherQos qos = efd::PUBLISHER_QOS_DEFAULT;
    for (const std::string& name : partitions) qos.partition().push_back(name.c_str());
    publisher = participant->create_publisher(qos);
    return publisher;
  }
  efd::Subscriber* subscriber(const Partitions& partitions) {
    const std::lock_guard lock(mutex);
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

  void list(const Guid& guid, bool is_writer, const EndpointOptions& options) {
    discovery.add_local({.guid = guid,
                         .is_writer = is_writer,
                         .topic = options.topic,
                         .type = options.type,
                         .qos = options.qos,
                         .user_data = options.user_data,
                         .partitions = options.partitions});
  }

  std::unique_ptr<Writer> open_writer(const EndpointOptions& options, std::function<void()> on_match) {
    efd::DataWriterQos qos = efd::DATAWRITER_QOS_DEFAULT;
    apply(options, qos);
    qos.publish_mode().kind = efd::SYNCHRONOUS_PUBLISH_MODE;
    if (options.heartbeat) fast_dds::set_heartbeat_period(qos, to_duration(*options.heartbeat));
    set_user_data(qos.user_data(), options.user_data);
    auto result = std::make_unique<FastWriter>(publisher(options.partitions), std::move(on_match), discovery);
    result->open(topic(options), qos);
    list(result->guid(), true, options);
    return result;
  }

  std::unique_ptr<Reader> open_reader(const EndpointOptions& options, std::function<void()> on_sample,
                                      std::function<void()> on_match) {
    efd::DataReaderQos qos = efd::DATAREADER_QOS_DEFAULT;
    apply(options, qos);
    // A writer that knew this reader before it was known itself has sent in vain: it is asked at once what it
    // has, since `ros2 topic pub --once` leaves after 100 ms. By default the question waits for 70 ms and the
    // answer's answer for 5.
    const fast_dds::Duration at_once = to_duration(Duration::milliseconds(1));
    fast_dds::set_answer_delays(qos, at_once, at_once);
    set_user_data(qos.user_data(), options.user_data);
    auto result = std::make_unique<FastReader>(subscriber(options.partitions), std::move(on_sample),
                                               std::move(on_match), discovery);
    result->open(topic(options), qos);
    list(result->guid(), false, options);
    return result;
  }
};

namespace {

/// Of nobody on the wire.
Guid guid_of_process() {
  static std::atomic<std::uint32_t> count = 0;
  const std::array<std::uint32_t, 2> parts = {static_cast<std::uint32_t>(getpid()), ++count};
  Guid guid{};
  std::memcpy(guid.data() + sizeof(std::uint32_t), parts.data(), sizeof(parts));
  return guid;
}

}  // namespace

Participant::Participant(const ParticipantOptions& options) : impl_(std::make_unique<Impl>()) {
  impl_->private_partition = options.private_partition;
  if (!options.alone) impl_->open(options);
  if (options.alone || !options.private_partition.empty())
    impl_->bus = std::make_shared<Bus>(options.alone ? guid_of_process() : guid());
}

Participant::~Participant() = default;

std::unique_ptr<Writer> Participant::create_writer(const EndpointOptions& options,
                                                   std::function<void()> on_match) {
  if (!impl_->goes_by_bus(options)) return impl_->open_writer(options, std::move(on_match));
  std::unique_ptr<Writer> outside;
  if (const auto shown = impl_->outside(options)) outside = impl_->open_writer(*shown, on_match);
  return impl_->bus->create_writer(options, std::move(on_match), std::move(outside));
}

std::unique_ptr<Reader> Participant::create_reader(const EndpointOptions& options,
                                                   std::function<void()> on_sample,
                                                   std::function<void()> on_match) {
  if (!impl_->goes_by_bus(options))
    return impl_->open_reader(options, std::move(on_sample), std::move(on_match));
  std::unique_ptr<Reader> outside;
  if (auto shown = impl_->outside(options)) {
    // That one is there to be seen: no writer of DDS is in the private partition.
    if (shown->partitions.empty()) shown->partitions = {impl_->private_partition};
    outside = impl_->open_reader(*shown, on_sample, on_match);
  }
  return impl_->bus->create_reader(options, std::move(on_sample), std::move(on_match), std::move(outside));
}

Guid Participant::guid() const {
  return impl_->participant != nullptr ? to_guid(impl_->participant->guid()) : impl_->bus->participant();
}

const std::string& Participant::private_partition() const { return impl_->private_partition; }

std::vector<Endpoint> Participant::endpoints() const { return impl_->discovery.endpoints(); }

std::vector<Endpoint> Participant::take_departed() { return impl_->discovery.take_departed(); }

std::uint64_t Participant::endpoint_changes() const { return impl_->discovery.changes(); }

std::optional<Duration> Participant::lease_of(const Guid& endpoint) const {
  return impl_->discovery.lease_of(endpoint);
}
std::vector<Guid> Participant::remote_participants() const { return impl_->discovery.participants(); }

}  // namespace bw::dds
