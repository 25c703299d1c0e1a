// Fast DDS 2.9 (Debian 12) and 3.1 (Debian 13) under one spelling: the headers, and names for what the two
// call differently. The only file with an #if on the version. Only sources of this folder include it, and test
// clients on plain Fast DDS.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#if __has_include(<fastdds/config.hpp>)
#include <fastdds/config.hpp>
#elif __has_include(<fastrtps/config.h>)
#include <fastrtps/config.h>
#endif

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
#include <fastdds/dds/topic/TopicDataType.hpp>

#if defined(FASTDDS_VERSION_MAJOR) && FASTDDS_VERSION_MAJOR == 3 && FASTDDS_VERSION_MINOR == 1
#define BANDWAGON_FAST_DDS_3 1
#include <fastdds/rtps/common/WriteParams.hpp>
#include <fastdds/rtps/transport/ChainingTransport.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.hpp>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.hpp>
#include <fastdds/utils/IPLocator.hpp>
#elif defined(FASTRTPS_VERSION_MAJOR) && FASTRTPS_VERSION_MAJOR == 2 && FASTRTPS_VERSION_MINOR >= 9
#define BANDWAGON_FAST_DDS_3 0
#include <fastdds/rtps/common/WriteParams.h>
#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/TransportReceiverInterface.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#else
#error \
    "This Fast DDS is not known here: runtime/dds/fast_dds.hpp has the spellings of 2.9 to 2.14 and of 3.1."
#endif

namespace bw::fast_dds {

namespace dds = eprosima::fastdds::dds;
namespace transport = eprosima::fastdds::rtps;

#if BANDWAGON_FAST_DDS_3
namespace rtps = eprosima::fastdds::rtps;
using Duration = dds::Duration_t;
using ReturnCode = dds::ReturnCode_t;
/// What a chained transport is given to send.
using SendBuffer = const std::vector<rtps::NetworkBuffer>&;
inline const Duration kInfinite = dds::c_TimeInfinite;
inline constexpr int kVersion[] = {FASTDDS_VERSION_MAJOR, FASTDDS_VERSION_MINOR, FASTDDS_VERSION_MICRO};
#else
namespace rtps = eprosima::fastrtps::rtps;
using Duration = eprosima::fastrtps::Duration_t;
using ReturnCode = ReturnCode_t;
using SendBuffer = const rtps::octet*;
inline const Duration kInfinite = eprosima::fastrtps::c_TimeInfinite;
inline constexpr int kVersion[] = {FASTRTPS_VERSION_MAJOR, FASTRTPS_VERSION_MINOR, FASTRTPS_VERSION_MICRO};
#endif

inline bool is_ok(const ReturnCode& code) {
#if BANDWAGON_FAST_DDS_3
  return code == dds::RETCODE_OK;
#else
  return code == ReturnCode_t::RETCODE_OK;
#endif
}

inline bool is_infinite(const Duration& duration) { return duration == kInfinite; }

/// False when the sample was refused.
inline bool write(dds::DataWriter& writer, void* sample) {
#if BANDWAGON_FAST_DDS_3
  return is_ok(writer.write(sample));
#else
  return writer.write(sample);
#endif
}
inline bool write(dds::DataWriter& writer, void* sample, rtps::WriteParams& params) {
#if BANDWAGON_FAST_DDS_3
  return is_ok(writer.write(sample, params));
#else
  return writer.write(sample, params);
#endif
}

/// How soon a reader asks a writer that it has just met, and how soon it answers a heartbeat.
inline void set_answer_delays(dds::DataReaderQos& qos, const Duration& first, const Duration& further) {
  auto& times = qos.reliable_reader_qos().times;
#if BANDWAGON_FAST_DDS_3
  times.initial_acknack_delay = first;
  times.heartbeat_response_delay = further;
#else
  times.initialAcknackDelay = first;
  times.heartbeatResponseDelay = further;
#endif
}

inline void set_heartbeat_period(dds::DataWriterQos& qos, const Duration& period) {
#if BANDWAGON_FAST_DDS_3
  qos.reliable_writer_qos().times.heartbeat_period = period;
#else
  qos.reliable_writer_qos().times.heartbeatPeriod = period;
#endif
}

/// No endpoints that exchange type descriptions: 3.x opens them by default, and no ROS 2 asks for them.
inline void disable_type_propagation([[maybe_unused]] dds::DomainParticipantQos& qos) {
#if BANDWAGON_FAST_DDS_3
  qos.properties().properties().emplace_back("fastdds.type_propagation", "disabled");
#endif
}

/// A type whose samples are serialised already.
class SerializedType : public dds::TopicDataType {
 public:
  /// `first_size`: of the first buffer, which grows with the samples [bytes].
  SerializedType(const std::string& name, std::uint32_t first_size);

  virtual std::span<const std::uint8_t> bytes_of(const void* sample) const = 0;
  virtual void assign(void* sample, std::span<const std::uint8_t> bytes) const = 0;
  virtual void* create() const = 0;
  virtual void destroy(void* sample) const = 0;

#if BANDWAGON_FAST_DDS_3
  bool serialize(const void* sample, rtps::SerializedPayload_t& payload, dds::DataRepresentationId_t) final {
    return fill(payload, sample);
  }
  bool deserialize(rtps::SerializedPayload_t& payload, void* sample) final {
    return assign(sample, {payload.data, payload.length}), true;
  }
  std::uint32_t calculate_serialized_size(const void* sample, dds::DataRepresentationId_t) final {
    return static_cast<std::uint32_t>(bytes_of(sample).size());
  }
  void* create_data() final { return create(); }
  void delete_data(void* sample) final { destroy(sample); }
  bool compute_key(rtps::SerializedPayload_t&, rtps::InstanceHandle_t&, bool) final { return false; }
  bool compute_key(const void*, rtps::InstanceHandle_t&, bool) final { return false; }
#else
  bool serialize(void* sample, rtps::SerializedPayload_t* payload) final { return fill(*payload, sample); }
  bool deserialize(rtps::SerializedPayload_t* payload, void* sample) final {
    return assign(sample, {payload->data, payload->length}), true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* sample) final {
    return [size = static_cast<std::uint32_t>(bytes_of(sample).size())] { return size; };
  }
  void* createData() final { return create(); }
  void deleteData(void* sample) final { destroy(sample); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) final { return false; }
#endif

 private:
  bool fill(rtps::SerializedPayload_t& payload, const void* sample) const {
    const std::span<const std::uint8_t> bytes = bytes_of(sample);
    if (bytes.size() > payload.max_size) return false;
    std::copy(bytes.begin(), bytes.end(), payload.data);
    payload.length = static_cast<std::uint32_t>(bytes.size());
    payload.encapsulation = CDR_LE;
    return true;
  }
};

inline SerializedType::SerializedType(const std::string& name, std::uint32_t first_size) {
#if BANDWAGON_FAST_DDS_3
  set_name(name);
  max_serialized_type_size = first_size;
  is_compute_key_provided = false;
#else
  setName(name.c_str());
  m_typeSize = first_size;
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
#endif
}

/// A reader or writer of another participant, as discovery tells it.
struct DiscoveredEndpoint {
  rtps::GUID_t guid;
  bool is_writer = false;
  std::string topic;
  std::string type;
  dds::ReliabilityQosPolicyKind reliability = dds::BEST_EFFORT_RELIABILITY_QOS;
  dds::DurabilityQosPolicyKind durability = dds::VOLATILE_DURABILITY_QOS;
  Duration lifespan;
  std::string user_data;
  std::vector<std::string> partitions;
};

enum class Presence {
  here,
  left,           ///< it said so
  lease_expired,  ///< without a word
};

/// What discovery tells, on a thread of DDS.
class DiscoveryEvents : public dds::DomainParticipantListener {
 public:
  virtual void on_participant(const rtps::GUID_t& guid, const Duration& lease, Presence presence) = 0;
  virtual void on_endpoint(const DiscoveredEndpoint& endpoint, Presence presence) = 0;

#if BANDWAGON_FAST_DDS_3
  void on_participant_discovery(dds::DomainParticipant*, rtps::ParticipantDiscoveryStatus status,
                                const dds::ParticipantBuiltinTopicData& data, bool&) final {
    using Status = rtps::ParticipantDiscoveryStatus;
    on_participant(data.guid, data.lease_duration,
                   status == Status::REMOVED_PARTICIPANT   ? Presence::left
                   : status == Status::DROPPED_PARTICIPANT ? Presence::lease_expired
                                                           : Presence::here);
  }
  void on_data_reader_discovery(dds::DomainParticipant*, rtps::ReaderDiscoveryStatus status,
                                const dds::SubscriptionBuiltinTopicData& data, bool&) final {
    on_endpoint(described(data, false), presence(status == rtps::ReaderDiscoveryStatus::REMOVED_READER));
  }
  void on_data_writer_discovery(dds::DomainParticipant*, rtps::WriterDiscoveryStatus status,
                                const dds::PublicationBuiltinTopicData& data, bool&) final {
    on_endpoint(described(data, true), presence(status == rtps::WriterDiscoveryStatus::REMOVED_WRITER));
  }
#else
  void on_participant_discovery(dds::DomainParticipant*, rtps::ParticipantDiscoveryInfo&& info) final {
    using Info = rtps::ParticipantDiscoveryInfo;
    on_participant(info.info.m_guid, info.info.m_leaseDuration,
                   info.status == Info::REMOVED_PARTICIPANT   ? Presence::left
                   : info.status == Info::DROPPED_PARTICIPANT ? Presence::lease_expired
                                                              : Presence::here);
  }
  void on_subscriber_discovery(dds::DomainParticipant*, rtps::ReaderDiscoveryInfo&& info) final {
    on_endpoint(described(info.info, false),
                presence(info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER));
  }
  void on_publisher_discovery(dds::DomainParticipant*, rtps::WriterDiscoveryInfo&& info) final {
    on_endpoint(described(info.info, true),
                presence(info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER));
  }
#endif

 private:
  static Presence presence(bool is_removed) { return is_removed ? Presence::left : Presence::here; }

  template <class Data>
  static DiscoveredEndpoint described(const Data& data, bool is_writer) {
    DiscoveredEndpoint endpoint;
    endpoint.is_writer = is_writer;
#if BANDWAGON_FAST_DDS_3
    endpoint.guid = data.guid;
    endpoint.topic = data.topic_name.to_string();
    endpoint.type = data.type_name.to_string();
    endpoint.reliability = data.reliability.kind;
    endpoint.durability = data.durability.kind;
    // A reader's lifespan is no part of what it announces in 3.x: every sample stays until it is taken.
    if constexpr (requires { data.lifespan; }) {
      endpoint.lifespan = data.lifespan.duration;
    } else {
      endpoint.lifespan = kInfinite;
    }
    endpoint.user_data.assign(data.user_data.begin(), data.user_data.end());
    endpoint.partitions = data.partition.names();
#else
    endpoint.guid = data.guid();
    endpoint.topic = data.topicName().to_string();
    endpoint.type = data.typeName().to_string();
    endpoint.reliability = data.m_qos.m_reliability.kind;
    endpoint.durability = data.m_qos.m_durability.kind;
    endpoint.lifespan = data.m_qos.m_lifespan.duration;
    endpoint.user_data.assign(data.m_qos.m_userData.begin(), data.m_qos.m_userData.end());
    endpoint.partitions = data.m_qos.m_partition.getNames();
#endif
    return endpoint;
  }
};

}  // namespace bw::fast_dds
