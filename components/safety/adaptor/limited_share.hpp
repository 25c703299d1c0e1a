// How often a driver was limited.
#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace bw {

class LimitedShare {
 public:
  void count(bool limited) {
    ++cycles_;
    limited_ += limited ? 1U : 0U;
  }
  std::uint64_t cycles() const { return cycles_; }
  std::string text() const {
    const double share = cycles_ > 0 ? static_cast<double>(limited_) / static_cast<double>(cycles_) : 0.0;
    return fmt::format("{:.2f} % of {} driving cycles", 100.0 * share, cycles_);
  }

 private:
  std::uint64_t cycles_ = 0;
  std::uint64_t limited_ = 0;
};

}  // namespace bw
