// Plain CDR (XCDR1) written and read by the letter of the standard, for programs that share nothing with the
// runtime: each value at a multiple of its size, counted from the first byte behind the encapsulation.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace plain {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::size_t kEncapsulation = 4;

/// Little endian, as every machine writes that this project runs on.
class CdrOut {
 public:
  template <class T>
  CdrOut& number(T value) {
    while ((bytes_.size() - kEncapsulation) % sizeof(T) != 0) bytes_.push_back(0);
    std::uint8_t raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    for (const std::uint8_t byte : raw) bytes_.push_back(byte);
    return *this;
  }
  /// Length with the NUL, characters, NUL.
  CdrOut& text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    bytes_.insert(bytes_.end(), value.begin(), value.end());
    bytes_.push_back(0);
    return *this;
  }
  template <class Range>
  CdrOut& octets(const Range& values) {
    for (const std::uint8_t value : values) bytes_.push_back(value);
    return *this;
  }
  const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_{0, 1, 0, 0};
};

/// Throws std::runtime_error beyond the end.
class CdrIn {
 public:
  explicit CdrIn(Bytes bytes) : bytes_(std::move(bytes)), at_(kEncapsulation) {
    if (bytes_.size() < kEncapsulation || bytes_[0] != 0 || bytes_[1] != 1)
      throw std::runtime_error("no little-endian plain CDR");
  }
  template <class T>
  T number() {
    at_ += (sizeof(T) - (at_ - kEncapsulation) % sizeof(T)) % sizeof(T);
    T value{};
    std::memcpy(&value, take(sizeof(T)), sizeof(T));
    return value;
  }
  std::string text() {
    const auto length = number<std::uint32_t>();
    if (length == 0) return {};
    return {reinterpret_cast<const char*>(take(length)), length - 1};
  }
  const std::uint8_t* take(std::size_t size) {
    if (size > bytes_.size() - at_) throw std::runtime_error("the bytes end early");
    at_ += size;
    return bytes_.data() + (at_ - size);
  }

 private:
  Bytes bytes_;
  std::size_t at_;
};

/// "00010000 01" -> bytes; spaces and line ends are free.
inline Bytes from_hex(std::string_view text) {
  Bytes bytes;
  std::string digits;
  for (const char c : text) {
    if (c == ' ' || c == '\n') continue;
    digits.push_back(c);
    if (digits.size() < 2) continue;
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(digits, nullptr, 16)));
    digits.clear();
  }
  if (!digits.empty()) throw std::logic_error("half a byte in " + std::string(text));
  return bytes;
}

inline std::string to_hex(const Bytes& bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text.push_back(kDigits[byte >> 4U]);
    text.push_back(kDigits[byte & 15U]);
  }
  return text;
}

/// RTPS fills a payload up to a multiple of 4.
inline Bytes padded(Bytes bytes) {
  while (bytes.size() % 4 != 0) bytes.push_back(0);
  return bytes;
}

}  // namespace plain
