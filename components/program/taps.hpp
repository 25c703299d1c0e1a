// Several that look at the samples of one run.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "runtime/host/sample_tap.hpp"

namespace bw {

class Taps final : public SampleTap {
 public:
  /// Before the run.
  void add(std::shared_ptr<SampleTap> tap) { taps_.push_back(std::move(tap)); }

  void connect(const std::vector<const OutputEnd*>& outputs) override {
    for (const auto& tap : taps_) tap->connect(outputs);
  }
  void on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) override {
    for (const auto& tap : taps_) tap->on_sample(output, now, cdr);
  }
  [[nodiscard]] bool wants_everything() const override {
    return std::ranges::any_of(taps_, [](const auto& tap) { return tap->wants_everything(); });
  }
  void run_is_over() override {
    for (const auto& tap : taps_) tap->run_is_over();
  }

 private:
  std::vector<std::shared_ptr<SampleTap>> taps_;
};

}  // namespace bw
