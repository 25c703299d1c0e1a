// A DDS type of any name whose samples are bytes as they are.
#pragma once

#include <functional>
#include <string>

#include <fastdds/dds/topic/TopicDataType.hpp>

#include "tests/interop/plain/cdr.hpp"

namespace plain {

class OctetsType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

  explicit OctetsType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = 64;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  bool serialize(void* data, Payload* payload) override {
    const Bytes& bytes = *static_cast<Bytes*>(data);
    if (bytes.size() > payload->max_size) return false;
    if (!bytes.empty()) std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    return true;
  }
  bool deserialize(Payload* payload, void* data) override {
    static_cast<Bytes*>(data)->assign(payload->data, payload->data + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

}  // namespace plain
