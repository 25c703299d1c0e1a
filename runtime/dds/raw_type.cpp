#include "runtime/dds/raw_type.hpp"

#include <algorithm>

namespace bw::dds {

namespace rtps = eprosima::fastrtps::rtps;

RawType::RawType(const std::string& dds_type_name) {
  setName(dds_type_name.c_str());
  m_typeSize = 256;  // first buffer size; grows with the samples
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool RawType::serialize(void* data, rtps::SerializedPayload_t* payload) {
  const auto& bytes = static_cast<RawSample*>(data)->outgoing;
  if (bytes.size() > payload->max_size) return false;
  std::ranges::copy(bytes, payload->data);
  payload->length = static_cast<std::uint32_t>(bytes.size());
  payload->encapsulation = CDR_LE;
  return true;
}

bool RawType::deserialize(rtps::SerializedPayload_t* payload, void* data) {
  static_cast<RawSample*>(data)->incoming.assign(payload->data, payload->data + payload->length);
  return true;
}

std::function<std::uint32_t()> RawType::getSerializedSizeProvider(void* data) {
  const std::size_t size = static_cast<RawSample*>(data)->outgoing.size();
  return [size] { return static_cast<std::uint32_t>(size); };
}

void* RawType::createData() { return new RawSample; }

void RawType::deleteData(void* data) { delete static_cast<RawSample*>(data); }

bool RawType::getKey(void*, rtps::InstanceHandle_t*, bool) { return false; }

}  // namespace bw::dds
