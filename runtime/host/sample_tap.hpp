// Sees every sample that the outputs of a process write, as it is written: for a recorder.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/time.hpp"

namespace bw {

class OutputEnd;

class SampleTap {
 public:
  virtual ~SampleTap() = default;
  /// Once, before the first sample: all outputs there are. They live until the run is over.
  virtual void connect(const std::vector<const OutputEnd*>& outputs) = 0;
  /// From any lane, several at a time in real time. Must not hold the caller up.
  virtual void on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) = 0;
  /// Outputs then behave as if somebody read them, and even costly messages that nobody asked for are made
  /// and seen.
  [[nodiscard]] virtual bool wants_everything() const { return true; }
  /// What comes after this is what components say when they are deactivated.
  virtual void run_is_over() {}
};

}  // namespace bw
