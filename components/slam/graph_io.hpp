// How a graph file is written and read, field by field, by the same calls (graph_fields.hpp); what is wrong, by its byte
// and rule. Of graph_file.cpp alone.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <zlib.h>

#include "components/slam/graph_file.hpp"

namespace bw::slam::graph {

inline constexpr std::string_view kMagic =
    "\x89"
    "BWG\r\n\x1a\n";
inline constexpr std::uint32_t kNone = 0xffffffff;

inline std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

template <class T>
using BitsOf = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

class Writer {
 public:
  static constexpr bool kReads = false;

  template <class T>
  void number(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) out_.push_back(static_cast<char>(value >> (8U * i)));
  }
  template <class T>
  void real(const char*, const T& value, double, double) {
    number(std::bit_cast<BitsOf<T>>(value));
  }
  void real_either_sign(const char*, const double& value, double, double) {
    number(std::bit_cast<std::uint64_t>(value));
  }
  template <class T>
  void integer(const char*, const T& value, std::int64_t, std::int64_t) {
    number(static_cast<BitsOf<T>>(value));
  }
  void short_number(const std::uint16_t& value) { number(value); }
  void flag(const char*, const bool& value) { number(static_cast<std::uint8_t>(value)); }
  void index(const char*, const std::size_t& value, std::size_t) {
    number(static_cast<std::uint32_t>(value));
  }
  void exactly(const char* name, const std::size_t& value, std::size_t, const char*) {
    index(name, value, 0);
  }
  void optional_index(const char*, const std::optional<std::size_t>& value, std::size_t) {
    number(value ? static_cast<std::uint32_t>(*value) : kNone);
  }
  void covariance(const Eigen::Matrix3d& C) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) number(std::bit_cast<std::uint64_t>(C(row, column)));
  }
  template <class Maybe, class Each>
  void optional(const Maybe& value, Each each) {
    flag("", static_cast<bool>(value));
    if (value) each(*value);
  }
  template <class T, class Each>
  void shared(const std::shared_ptr<const T>& value, Each each) {
    each(*value);
  }
  template <class T, class Each>
  void list_of(const char*, const std::vector<T>& list, std::size_t, std::size_t, Each each) {
    for (const T& item : list) each(item);
  }
  template <class T, class Each>
  void list(const char* name, const std::vector<T>& list, std::size_t bytes, Each each) {
    number(static_cast<std::uint32_t>(list.size()));
    list_of(name, list, list.size(), bytes, each);
  }

  template <class Content>
  void section(std::string_view tag, Content content) {
    const std::size_t start = out_.size();
    out_ += tag;
    number(std::uint64_t{0});
    content();
    overwrite(start + 4, out_.size() - start - 12);
    number(checksum(std::string_view(out_).substr(start)));
  }
  void raw(std::string_view bytes) { out_ += bytes; }
  void overwrite(std::size_t at, std::uint64_t value) {
    for (std::size_t i = 0; i < 8; ++i) out_[at + i] = static_cast<char>(value >> (8U * i));
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

struct Fault {
  std::string sentence;
};

inline std::string text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.9g", value);
  return buffer.data();
}

class Reader {
 public:
  static constexpr bool kReads = true;
  explicit Reader(std::string_view bytes) : bytes_(bytes), end_(bytes.size()) {}

  template <class T>
  T number(const char* name) {
    field_ = at_;
    if (end_ - at_ < sizeof(T))
      refuse(name, std::to_string(end_ - at_) + " bytes", "the section ends before it does");
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      sum |= std::uint64_t{static_cast<std::uint8_t>(bytes_[at_ + i])} << (8U * i);
    at_ += sizeof(T);
    return static_cast<T>(sum);
  }
  template <class T>
  void real(const char* name, T& value, double least, double most) {
    value = std::bit_cast<T>(number<BitsOf<T>>(name));
    const auto wide = static_cast<double>(value);
    if (!(wide >= least && wide <= most))
      refuse(name, text(wide), "must lie within " + text(least) + " and " + text(most));
  }
  void real_either_sign(const char* name, double& value, double least, double most) {
    value = std::bit_cast<double>(number<std::uint64_t>(name));
    if (!(std::abs(value) >= least && std::abs(value) <= most))
      refuse(name, text(value), "its size must lie within " + text(least) + " and " + text(most));
  }
  template <class T>
  void integer(const char* name, T& value, std::int64_t least, std::int64_t most) {
    value = static_cast<T>(number<BitsOf<T>>(name));
    if (value < least || value > most)
      refuse(name, std::to_string(value),
             "must lie within " + std::to_string(least) + " and " + std::to_string(most));
  }
  void short_number(std::uint16_t& value) { value = number<std::uint16_t>("a range"); }
  void flag(const char* name, bool& value) {
    const auto byte = number<std::uint8_t>(name);
    if (byte > 1) refuse(name, std::to_string(byte), "must be 0 or 1");
    value = byte == 1;
  }
  void index(const char* name, std::size_t& value, std::size_t end) {
    value = number<std::uint32_t>(name);
    if (value >= end) refuse(name, std::to_string(value), "must be below " + std::to_string(end));
  }
  void exactly(const char* name, std::size_t& value, std::size_t wanted, const char* what) {
    value = number<std::uint32_t>(name);
    if (value != wanted)
      refuse(name, std::to_string(value), "must be " + std::string(what) + ", " + std::to_string(wanted));
  }
  void optional_index(const char* name, std::optional<std::size_t>& value, std::size_t end) {
    const auto read = number<std::uint32_t>(name);
    if (read != kNone && read >= end)
      refuse(name, std::to_string(read), "must be below " + std::to_string(end) + ", or 4294967295 for none");
    value = read == kNone ? std::nullopt : std::optional<std::size_t>(read);
  }
  // Of what is added up and inverted: a covariance that is none lets poses become numbers that are none.
  void covariance(Eigen::Matrix3d& C) {
    const std::size_t start = at_;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) real("covariance", C(row, column), -1e12, 1e12);
    field_ = start;
    const double largest = std::max(1.0, C.cwiseAbs().maxCoeff());
    if ((C - C.transpose()).cwiseAbs().maxCoeff() > 1e-9 * largest)
      refuse("covariance", text(C(0, 1)) + " and " + text(C(1, 0)), "must be symmetric");
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(C, Eigen::EigenvaluesOnly);
    if (eigen.info() != Eigen::Success || !(eigen.eigenvalues()(0) >= -1e-9 * largest))
      refuse("covariance", "an eigenvalue of " + text(eigen.eigenvalues()(0)), "none must be negative");
  }
  template <class T, class Each>
  void optional(std::optional<T>& value, Each each) {
    bool is_there = false;
    flag("whether it is there", is_there);
    if (is_there) each(value.emplace());
  }
  template <class T, class Each>
  void shared(std::shared_ptr<const T>& value, Each each) {
    const auto made = std::make_shared<T>();
    each(*made);
    value = made;
  }
  template <class T, class Each>
  void list_of(const char* name, std::vector<T>& list, std::size_t count, std::size_t bytes, Each each) {
    if (count > (end_ - at_) / bytes)
      refuse(name, std::to_string(count),
             "has no room in the " + std::to_string(end_ - at_) + " bytes that are left");
    list.resize(count);
    for (T& item : list) each(item);
  }
  template <class T, class Each>
  void list(const char* name, std::vector<T>& list, std::size_t bytes, Each each) {
    const auto count = number<std::uint32_t>(name);
    list_of(name, list, count, bytes, each);
  }

  void header() {
    if (bytes_.substr(0, kMagic.size()) != kMagic)
      refuse("first 8 bytes", "another kind of file", "must be those of a pose graph");
    at_ = kMagic.size();
    const auto version = number<std::uint32_t>("version");
    if (version != kGraphVersion)
      refuse("version", std::to_string(version),
             "this program reads version " + std::to_string(kGraphVersion));
    const auto size = number<std::uint64_t>("size");
    if (size != bytes_.size())
      refuse("size", std::to_string(size), "the file has " + std::to_string(bytes_.size()) + " bytes");
  }
  template <class Content>
  void section(std::string_view tag, Content content) {
    section_ = tag;
    end_ = bytes_.size();
    const std::size_t start = at_;
    field_ = start;
    if (bytes_.substr(start, tag.size()) != tag) refuse("section", "another one", "must begin with its name");
    at_ += tag.size();
    const auto size = number<std::uint64_t>("length");
    if (end_ - at_ < 4 || size > end_ - at_ - 4)
      refuse("length", std::to_string(size),
             "the file ends after " + std::to_string(end_ - at_) + " bytes more");
    end_ = at_ + static_cast<std::size_t>(size);
    const std::uint32_t computed = checksum(bytes_.substr(start, end_ - start));
    const std::size_t content_at = at_;
    at_ = end_;
    end_ += 4;
    const auto stored = number<std::uint32_t>("checksum");
    if (stored != computed)
      refuse("checksum", std::to_string(stored),
             "the bytes have " + std::to_string(computed) + ": they were changed");
    at_ = content_at;
    end_ -= 4;
    content();
    field_ = at_;
    if (at_ != end_) refuse("end", std::to_string(end_ - at_) + " bytes more", "the section must end here");
    at_ += 4;
  }
  void end() {
    if (at_ != bytes_.size())
      refuse("end", std::to_string(bytes_.size() - at_) + " bytes more", "the file must end here");
  }
  [[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& rule) const {
    throw Fault{"byte " + std::to_string(field_) + (section_.empty() ? "" : " (" + section_ + ")") + ": " +
                name + ": " + value + ": " + rule};
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;
  std::size_t field_ = 0;  // where the field begins that is looked at
  std::string section_;
};

}  // namespace bw::slam::graph
