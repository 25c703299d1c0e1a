// SHA-256 over a run's samples, in the order they were written.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "runtime/base/time.hpp"

namespace bw {

class SampleHash {
 public:
  SampleHash();
  ~SampleHash();
  SampleHash(const SampleHash&) = delete;
  SampleHash& operator=(const SampleHash&) = delete;

  void add(std::string_view topic, Time time, std::span<const std::uint8_t> bytes);
  /// Of all samples so far, 64 hex digits.
  std::string hex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bw
