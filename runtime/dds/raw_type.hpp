// A Fast DDS type that carries serialised samples untouched: our own code serialises, validates and hashes
// the bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/dds/fast_dds.hpp"

namespace bw::dds {

/// What the data pointer of a raw write or take points to.
struct RawSample {
  std::span<const std::uint8_t> outgoing;  ///< bytes to write
  std::vector<std::uint8_t> incoming;      ///< bytes taken
};

class RawType final : public fast_dds::SerializedType {
 public:
  explicit RawType(const std::string& dds_type_name) : SerializedType(dds_type_name, 256) {}

  std::span<const std::uint8_t> bytes_of(const void* sample) const override {
    return static_cast<const RawSample*>(sample)->outgoing;
  }
  void assign(void* sample, std::span<const std::uint8_t> bytes) const override {
    static_cast<RawSample*>(sample)->incoming.assign(bytes.begin(), bytes.end());
  }
  void* create() const override { return new RawSample; }
  void destroy(void* sample) const override { delete static_cast<RawSample*>(sample); }
};

}  // namespace bw::dds
