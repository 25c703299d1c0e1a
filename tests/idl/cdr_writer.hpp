// A second, independent hand at XCDR1: writes values one after the other, aligned to their size from the
// first byte after the encapsulation. Knows nothing of Fast CDR; the tests hold the product against it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/wire/type_description.hpp"

namespace bw::test {

class CdrWriter {
 public:
  explicit CdrWriter(bool big_endian = false) : big_endian_(big_endian) {
    bytes_ = {0, static_cast<std::uint8_t>(big_endian ? 0 : 1), 0, 0};
  }

  template <class T>
  CdrWriter& put(T value) {
    while ((bytes_.size() - 4) % sizeof(T) != 0) bytes_.push_back(0);
    std::uint8_t raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big_endian_) std::reverse(raw, raw + sizeof(T));
    for (const std::uint8_t byte : raw) bytes_.push_back(byte);
    return *this;
  }
  CdrWriter& text(std::string_view value) {
    put(static_cast<std::uint32_t>(value.size() + 1));
    for (const char c : value) bytes_.push_back(static_cast<std::uint8_t>(c));
    bytes_.push_back(0);
    return *this;
  }
  template <class... T>
  CdrWriter& doubles(T... values) {
    (put(static_cast<double>(values)), ...);
    return *this;
  }
  template <class... T>
  CdrWriter& floats(T... values) {
    (put(static_cast<float>(values)), ...);
    return *this;
  }
  CdrWriter& header(std::int32_t sec, std::uint32_t nanosec, std::string_view frame) {
    return put(sec).put(nanosec).text(frame);
  }

  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  bool big_endian_;
  std::vector<std::uint8_t> bytes_;
};

/// A valid message of `type` with random values; sequences of up to `longest` elements, or as many as they
/// may have, texts of up to 8 characters.
class RandomPayload {
 public:
  RandomPayload(std::uint64_t seed, std::uint32_t longest) : random_(seed), longest_(longest) {}

  std::vector<std::uint8_t> operator()(const TypeDescription& type, bool big_endian = false) {
    CdrWriter writer(big_endian);
    fields(type, writer);
    return writer.bytes();
  }

 private:
  void fields(const TypeDescription& type, CdrWriter& writer) {
    for (const FieldDescription& field : type.fields) {
      std::uint32_t count = field.shape == Shape::kArray ? field.capacity : 1;
      if (field.shape == Shape::kSequence) {
        const std::uint32_t bound = field.capacity == 0 ? longest_ : std::min(longest_, field.capacity);
        count = below(bound + 1);
        writer.put(count);
      }
      for (std::uint32_t i = 0; i < count; ++i) element(field, writer);
    }
  }

  void element(const FieldDescription& field, CdrWriter& writer) {
    switch (field.kind) {
      case Kind::kBoolean:
        writer.put(static_cast<std::uint8_t>(below(2)));
        return;
      case Kind::kFloat32:
        writer.put(static_cast<float>(below(2000)) / 8.0F - 100.0F);
        return;
      case Kind::kFloat64:
        writer.put(static_cast<double>(below(2000)) / 8.0 - 100.0);
        return;
      case Kind::kString: {
        std::string text(below(9), ' ');
        for (char& c : text) c = static_cast<char>('a' + below(26));
        writer.text(text);
        return;
      }
      case Kind::kMessage:
        fields(*field.message, writer);
        return;
      default:
        break;
    }
    switch (wire_size(field.kind)) {
      case 1:
        writer.put(static_cast<std::uint8_t>(random_()));
        return;
      case 2:
        writer.put(static_cast<std::uint16_t>(random_()));
        return;
      case 4:
        writer.put(static_cast<std::uint32_t>(random_()));
        return;
      default:
        writer.put(static_cast<std::uint64_t>(random_()));
    }
  }

  std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }

  std::mt19937_64 random_;
  std::uint32_t longest_;
};

}  // namespace bw::test
