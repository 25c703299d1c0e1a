// Values between Fast DDS and us. Only sources of this folder include it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "runtime/dds/fast_dds.hpp"
#include "runtime/dds/participant.hpp"

namespace bw::dds {

namespace efd = fast_dds::dds;
namespace rtps = fast_dds::rtps;

inline Guid to_guid(const rtps::GUID_t& guid) {
  Guid result{};
  std::copy_n(guid.guidPrefix.value, 12, result.begin());
  std::copy_n(guid.entityId.value, 4, result.begin() + 12);
  return result;
}

inline rtps::GUID_t to_rtps(const Guid& guid) {
  rtps::GUID_t result;
  std::copy_n(guid.begin(), 12, result.guidPrefix.value);
  std::copy_n(guid.begin() + 12, 4, result.entityId.value);
  return result;
}

inline SampleIdentity to_identity(const rtps::SampleIdentity& identity) {
  if (identity.writer_guid() == rtps::c_Guid_Unknown) return {};
  return {to_guid(identity.writer_guid()), static_cast<std::int64_t>(identity.sequence_number().to64long())};
}

inline fast_dds::Duration to_duration(Duration d) {
  return {static_cast<std::int32_t>(d.nanoseconds / 1'000'000'000),
          static_cast<std::uint32_t>(d.nanoseconds % 1'000'000'000)};
}

/// What is no time (a writer need not tell any) becomes 0.
inline Time to_time(const rtps::Time_t& time) {
  if (time.seconds() <= 0 || time == rtps::c_RTPSTimeInfinite) return {};
  return {std::int64_t{time.seconds()} * 1'000'000'000 + time.nanosec()};
}

inline void set_user_data(efd::UserDataQosPolicy& policy, const std::string& text) {
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

}  // namespace bw::dds
