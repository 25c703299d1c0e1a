// A Fast DDS type that carries serialised samples untouched: our own code serialises, validates and hashes
// the bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <fastdds/dds/topic/TopicDataType.hpp>

namespace bw::dds {

/// What the data pointer of a raw write or take points to.
struct RawSample {
  std::span<const std::uint8_t> outgoing;  ///< bytes to write
  std::vector<std::uint8_t> incoming;      ///< bytes taken
};

class RawType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  explicit RawType(const std::string& dds_type_name);

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override;
};

}  // namespace bw::dds
