// A DDS type of any name whose samples are bytes as they are.
#pragma once

#include <string>

#include "runtime/dds/fast_dds.hpp"
#include "tests/interop/plain/cdr.hpp"

namespace plain {

class OctetsType final : public bw::fast_dds::SerializedType {
 public:
  explicit OctetsType(const std::string& name) : SerializedType(name, 64) {}

  std::span<const std::uint8_t> bytes_of(const void* sample) const override {
    return *static_cast<const Bytes*>(sample);
  }
  void assign(void* sample, std::span<const std::uint8_t> bytes) const override {
    static_cast<Bytes*>(sample)->assign(bytes.begin(), bytes.end());
  }
  void* create() const override { return new Bytes; }
  void destroy(void* sample) const override { delete static_cast<Bytes*>(sample); }
};

}  // namespace plain
