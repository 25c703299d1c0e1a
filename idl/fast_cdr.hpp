// One message through Fast CDR. Only generated sources include this; everyone else uses
// runtime/wire/serialization.hpp.
#pragma once

#include <cstdint>
#include <exception>
#include <span>
#include <string>
#include <vector>

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include "runtime/wire/validate.hpp"

namespace bw::fast_cdr {

inline constexpr std::size_t kEncapsulationSize = 4;

template <class M>
void serialize(const M& message, std::vector<std::uint8_t>& bytes) {
  // Fast CDR leaves padding as it finds it, hence the zeros.
  bytes.assign(kEncapsulationSize + M::getCdrSerializedSize(message), 0);
  eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS,
                             eprosima::fastcdr::Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  message.serialize(cdr);
}

template <class M>
bool deserialize(const TypeDescription& type, std::span<const std::uint8_t> bytes, M& message,
                 std::string* reason) {
  if (!validate(type, bytes, reason)) return false;
  try {
    // Fast CDR only reads here, but its buffer has no const form.
    auto* data = const_cast<char*>(reinterpret_cast<const char*>(bytes.data()));
    eprosima::fastcdr::FastBuffer buffer(data, bytes.size());
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    cdr.read_encapsulation();
    message.deserialize(cdr);
    return true;
  } catch (const std::exception& error) {
    if (reason != nullptr) *reason = std::string(type.ros_name) + ": " + error.what();
    return false;
  }
}

}  // namespace bw::fast_cdr
