#include "tests/interop/plain/node.hpp"

#include <algorithm>
#include <cstdlib>

#include "tests/interop/plain/octets_type.hpp"

namespace plain {
namespace {

constexpr const char* kGraphTopic = "ros_discovery_info";
constexpr const char* kGraphHash =  // from Iron on
    "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e";
constexpr const char* kGraphType = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";

int domain_id() {
  const char* text = std::getenv("ROS_DOMAIN_ID");
  return text == nullptr ? 0 : std::atoi(text);
}

rtps::Locator_t loopback() {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  locator.port = 0;
  rtps::IPLocator::setIPv4(locator, "127.0.0.1");
  return locator;
}

// UDP over unicast, peers sought on this machine's first ports: what ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST
// makes of rmw_fastrtps; with loopback's address alone announced, as ROS_LOCALHOST_ONLY=1 does.
dds::DomainParticipantQos participant_qos(std::shared_ptr<Wire> wire) {
  dds::DomainParticipantQos qos = dds::PARTICIPANT_QOS_DEFAULT;
  qos.name("/");
  const std::string user_data = "enclave=/;";
  qos.user_data().setValue(std::vector<rtps::octet>(user_data.begin(), user_data.end()));
  auto udp = std::make_shared<bw::fast_dds::transport::UDPv4TransportDescriptor>();
  udp->maxInitialPeersRange = 32;
  qos.transport().use_builtin_transports = false;
  if (wire) {
    qos.transport().user_transports.push_back(recorded(udp, std::move(wire)));
  } else {
    qos.transport().user_transports.push_back(udp);
  }
  auto& builtin = qos.wire_protocol().builtin;
  builtin.metatrafficUnicastLocatorList.push_back(loopback());
  builtin.initialPeersList.push_back(loopback());
  qos.wire_protocol().default_unicast_locator_list.push_back(loopback());
  builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  return qos;
}

template <class Qos>
void set_service_qos(const EndOptions& options, Qos& qos) {
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind =
      options.is_latched ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = options.depth;
  qos.data_sharing().off();
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.endpoint().entity_id = static_cast<std::int16_t>(options.entity_id);
  if (options.type_hash.empty()) return;
  const std::string user_data = "typehash=" + options.type_hash + ";";
  qos.user_data().setValue(std::vector<rtps::octet>(user_data.begin(), user_data.end()));
}

template <class Qos>
void set_graph_qos(Qos& qos) {
  set_service_qos({.topic = {}, .type = {}, .type_hash = kGraphHash, .depth = 1, .is_latched = true}, qos);
}

End to_end(const bw::fast_dds::DiscoveredEndpoint& data) {
  return {.topic = data.topic,
          .type = data.type,
          .user_data = data.user_data,
          .is_writer = data.is_writer,
          .is_reliable = data.reliability == dds::RELIABLE_RELIABILITY_QOS,
          .is_volatile = data.durability == dds::VOLATILE_DURABILITY_QOS};
}

}  // namespace

Gid to_gid(const rtps::GUID_t& guid) {
  Gid gid{};
  std::copy_n(guid.guidPrefix.value, 12, gid.begin());
  std::copy_n(guid.entityId.value, 4, gid.begin() + 12);
  return gid;
}

class Node::Listener final : public bw::fast_dds::DiscoveryEvents {
 public:
  void on_participant(const rtps::GUID_t& guid, const bw::fast_dds::Duration&,
                      bw::fast_dds::Presence presence) override {
    if (presence == bw::fast_dds::Presence::here) return;
    const Gid gone = to_gid(guid);
    const std::lock_guard lock(mutex_);
    if (presence == bw::fast_dds::Presence::lease_expired) ++expired_;
    std::erase_if(ends_, [&](const auto& item) {
      return std::equal(gone.begin(), gone.begin() + 12, item.first.begin());
    });
  }
  void on_endpoint(const bw::fast_dds::DiscoveredEndpoint& data, bw::fast_dds::Presence presence) override {
    set(to_gid(data.guid), to_end(data), presence != bw::fast_dds::Presence::here);
  }
  void set(const Gid& gid, End end, bool is_gone) {
    const std::lock_guard lock(mutex_);
    if (is_gone) {
      ends_.erase(gid);
    } else {
      ends_[gid] = std::move(end);
    }
  }
  std::map<Gid, End> ends() const {
    const std::lock_guard lock(mutex_);
    return ends_;
  }
  int expired() const {
    const std::lock_guard lock(mutex_);
    return expired_;
  }
  int count(const std::string& topic, bool is_writer) const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(std::ranges::count_if(ends_, [&](const auto& item) {
      return item.second.topic == topic && item.second.is_writer == is_writer;
    }));
  }

 private:
  mutable std::mutex mutex_;
  std::map<Gid, End> ends_;
  int expired_ = 0;
};

Node::Node(std::string name, std::shared_ptr<Wire> wire, GidSize gid_size)
    : name_(std::move(name)), gid_size_(gid_size), listener_(std::make_unique<Listener>()) {
  dds::Log::SetVerbosity(dds::Log::Kind::Error);
  participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
      static_cast<dds::DomainId_t>(domain_id()), participant_qos(std::move(wire)), listener_.get(),
      dds::StatusMask::none());
  if (participant_ == nullptr) throw std::runtime_error("no participant");
  publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  dds::DataWriterQos writer_qos = dds::DATAWRITER_QOS_DEFAULT;
  set_graph_qos(writer_qos);
  graph_writer_ = publisher_->create_datawriter(topic(kGraphTopic, kGraphType), writer_qos);
  dds::DataReaderQos reader_qos = dds::DATAREADER_QOS_DEFAULT;
  set_graph_qos(reader_qos);
  reader_qos.history().kind = dds::KEEP_ALL_HISTORY_QOS;
  graph_reader_ = subscriber_->create_datareader(topic(kGraphTopic, kGraphType), reader_qos);
  const EndOptions graph{.topic = kGraphTopic, .type = kGraphType, .type_hash = kGraphHash};
  listener_->set(to_gid(graph_writer_->guid()), described(graph, true), false);
  listener_->set(to_gid(graph_reader_->guid()), described(graph, false), false);
  announce();
}

Node::~Node() {
  participant_->set_listener(nullptr);
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

dds::Topic* Node::topic(const std::string& name, const std::string& type) {
  if (dds::TopicDescription* known = participant_->lookup_topicdescription(name))
    return static_cast<dds::Topic*>(known);
  dds::TypeSupport support(new OctetsType(type));
  support.register_type(participant_);
  dds::Topic* created = participant_->create_topic(name, type, dds::TOPIC_QOS_DEFAULT);
  if (created == nullptr) throw std::runtime_error("no topic " + name);
  return created;
}

End Node::described(const EndOptions& options, bool is_writer) const {
  return {
      .topic = options.topic, .type = options.type, .user_data = {}, .is_writer = is_writer, .is_own = true};
}

dds::DataWriter* Node::create_writer(const EndOptions& options, dds::DataWriterListener* listener) {
  dds::DataWriterQos qos = dds::DATAWRITER_QOS_DEFAULT;
  set_service_qos(options, qos);
  qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  dds::DataWriter* writer = publisher_->create_datawriter(
      topic(options.topic, options.type), qos, listener,
      listener == nullptr ? dds::StatusMask::none() : dds::StatusMask::publication_matched());
  if (writer == nullptr) throw std::runtime_error("no writer on " + options.topic);
  writers_.insert(to_gid(writer->guid()));
  listener_->set(to_gid(writer->guid()), described(options, true), false);
  return writer;
}

dds::DataReader* Node::create_reader(const EndOptions& options) {
  dds::DataReaderQos qos = dds::DATAREADER_QOS_DEFAULT;
  set_service_qos(options, qos);
  dds::DataReader* reader = subscriber_->create_datareader(topic(options.topic, options.type), qos);
  if (reader == nullptr) throw std::runtime_error("no reader on " + options.topic);
  readers_.insert(to_gid(reader->guid()));
  listener_->set(to_gid(reader->guid()), described(options, false), false);
  return reader;
}

void Node::remove(dds::DataWriter* writer) {
  writers_.erase(to_gid(writer->guid()));
  listener_->set(to_gid(writer->guid()), {}, true);
  publisher_->delete_datawriter(writer);
}

void Node::remove(dds::DataReader* reader) {
  readers_.erase(to_gid(reader->guid()));
  listener_->set(to_gid(reader->guid()), {}, true);
  subscriber_->delete_datareader(reader);
}

void Node::announce() {
  CdrOut cdr;
  const auto octets = [&](const Gid& gid) {
    Bytes bytes(gid.begin(), gid.end());
    bytes.resize(static_cast<std::size_t>(gid_size_));
    cdr.octets(bytes);
  };
  octets(to_gid(participant_->guid()));
  cdr.number(std::uint32_t{1}).text("/").text(name_);
  for (const std::set<Gid>* gids : {&readers_, &writers_}) {
    cdr.number(static_cast<std::uint32_t>(gids->size()));
    for (const Gid& gid : *gids) octets(gid);
  }
  Bytes bytes = cdr.bytes();
  graph_writer_->write(&bytes);
}

std::map<Gid, End> Node::ends() const { return listener_->ends(); }

int Node::count(const std::string& topic_name, bool is_writer) const {
  return listener_->count(topic_name, is_writer);
}

int Node::expired() const { return listener_->expired(); }

rtps::GUID_t Node::guid() const { return participant_->guid(); }

std::vector<NodeInfo> Node::nodes() {
  Bytes bytes;
  dds::SampleInfo info;
  while (bw::fast_dds::is_ok(graph_reader_->take_next_sample(&bytes, &info))) {
    if (!info.valid_data) continue;
    CdrIn cdr(bytes);
    const auto gid = [&] {
      Gid value{};
      std::copy_n(cdr.take(static_cast<std::size_t>(gid_size_)), value.size(), value.begin());
      return value;
    };
    const Gid participant = gid();
    std::vector<NodeInfo> nodes(cdr.number<std::uint32_t>());
    for (NodeInfo& node : nodes) {
      const std::string space = cdr.text();
      node.name = (space == "/" ? "" : space) + "/" + cdr.text();
      for (std::set<Gid>* gids : {&node.readers, &node.writers}) {
        for (auto left = cdr.number<std::uint32_t>(); left > 0; --left) gids->insert(gid());
      }
    }
    if (participant != to_gid(participant_->guid())) nodes_[participant] = std::move(nodes);
  }
  std::vector<NodeInfo> all;
  for (const auto& [participant, nodes] : nodes_) all.insert(all.end(), nodes.begin(), nodes.end());
  return all;
}

}  // namespace plain
