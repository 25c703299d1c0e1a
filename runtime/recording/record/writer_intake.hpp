// Which samples of one writer are recorded, each once and in order, and how many were lost on the way.
//
// A topic has a reader for each quality of service that is offered on it, so that a reliable writer beside a
// best-effort one is heard reliably and a latched one with what it wrote before. Such a writer is heard by
// the weaker reader as well.
#pragma once

#include <cstdint>

namespace bw::record {

class WriterIntake {
 public:
  /// Whether to record the sample. `by_own`: it came by the reader made for what this writer offers; the
  /// others count until that one has spoken. Sequences of a writer begin at 1.
  [[nodiscard]] bool accept(std::uint64_t sequence, bool by_own);

  /// Samples that never came by the own reader, between the first and the last that did.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  std::uint64_t last_own_ = 0;
  std::uint64_t first_other_ = 0;  ///< 0: none came by another reader
  std::uint64_t last_other_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace bw::record
