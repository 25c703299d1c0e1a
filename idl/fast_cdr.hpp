// One message through Fast CDR. Only generated sources include this; everyone else uses
// runtime/wire/serialization.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include "runtime/wire/validate.hpp"

namespace bw::fast_cdr {

using namespace eprosima::fastcdr;  // where Fast CDR 2 has DDS_CDR; 1 has it in its class

/// Classic CDR, what ROS 2 sends.
struct ClassicCdr : Cdr {
  ClassicCdr(FastBuffer& buffer, Endianness endianness) : Cdr(buffer, endianness, DDS_CDR) {}
};

inline constexpr std::size_t kEncapsulationSize = 4;

template <class T>
struct ElementOf {
  using Type = void;
};
template <class T>
struct ElementOf<std::vector<T>> {
  using Type = T;
};
template <class T, std::size_t kSize>
struct ElementOf<std::array<T, kSize>> {
  using Type = T;
};

/// What Fast CDR writes in one go: a number, a text, or several of one of them.
template <class T>
inline constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_same_v<T, std::string>;
template <class T>
inline constexpr bool kIsSeveral = !std::is_void_v<typename ElementOf<T>::Type>;

/// Bytes that fields will take after the encapsulation.
struct Measure {
  std::size_t bytes = 0;

  template <class T>
  void operator()(const T& value) {
    using Element = typename ElementOf<T>::Type;
    if constexpr (std::is_arithmetic_v<T>) {
      add(sizeof(T), 1);
    } else if constexpr (std::is_same_v<T, std::string>) {
      add(sizeof(std::uint32_t), 1);
      bytes += value.size() + 1;
    } else if constexpr (kIsSeveral<T>) {
      if constexpr (std::is_same_v<T, std::vector<Element>>) add(sizeof(std::uint32_t), 1);
      if constexpr (std::is_arithmetic_v<Element>) {
        add(sizeof(Element), value.size());
      } else {
        for (const Element& element : value) (*this)(element);
      }
    } else {
      value.for_each_field(*this);
    }
  }

 private:
  void add(std::size_t size, std::size_t count) {
    if (count > 0) bytes = (bytes + size - 1) / size * size + size * count;
  }
};

struct Write {
  Cdr& cdr;

  template <class T>
  void operator()(const T& value) {
    using Element = typename ElementOf<T>::Type;
    if constexpr (kIsPlain<T> || kIsPlain<Element>) {
      cdr << value;
    } else if constexpr (kIsSeveral<T>) {
      if constexpr (std::is_same_v<T, std::vector<Element>>) cdr << static_cast<std::uint32_t>(value.size());
      for (const Element& element : value) (*this)(element);
    } else {
      value.for_each_field(*this);
    }
  }
};

/// The bytes were validated: a length that is read here has its elements behind it.
struct Read {
  Cdr& cdr;

  template <class T>
  void operator()(T& value) {
    using Element = typename ElementOf<T>::Type;
    if constexpr (kIsPlain<T> || kIsPlain<Element>) {
      cdr >> value;
    } else if constexpr (kIsSeveral<T>) {
      if constexpr (std::is_same_v<T, std::vector<Element>>) {
        std::uint32_t size = 0;
        cdr >> size;
        value.resize(size);
      }
      for (Element& element : value) (*this)(element);
    } else {
      value.for_each_field(*this);
    }
  }
};

template <class M>
void serialize(const M& message, std::vector<std::uint8_t>& bytes) {
  Measure measure;
  measure(message);
  // Fast CDR leaves padding as it finds it, hence the zeros.
  bytes.assign(kEncapsulationSize + measure.bytes, 0);
  FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  ClassicCdr cdr(buffer, Cdr::LITTLE_ENDIANNESS);
  cdr.serialize_encapsulation();
  Write{cdr}(message);
}

template <class M>
bool deserialize(const TypeDescription& type, std::span<const std::uint8_t> bytes, M& message,
                 std::string* reason) {
  if (!validate(type, bytes, reason)) return false;
  try {
    // Fast CDR only reads here, but its buffer has no const form.
    auto* data = const_cast<char*>(reinterpret_cast<const char*>(bytes.data()));
    FastBuffer buffer(data, bytes.size());
    ClassicCdr cdr(buffer, Cdr::DEFAULT_ENDIAN);
    cdr.read_encapsulation();
    Read{cdr}(message);
    return true;
  } catch (const std::exception& error) {
    if (reason != nullptr) *reason = std::string(type.ros_name) + ": " + error.what();
    return false;
  }
}

}  // namespace bw::fast_cdr
