// Records what the outputs of a process write, without a second serialisation: their bytes go into the bag as
// they are.
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "runtime/host/sample_tap.hpp"
#include "runtime/recording/bag/recorder.hpp"

namespace bw::bag {

class RunRecorder final : public SampleTap {
 public:
  /// Throws as BagWriter does.
  RunRecorder(const std::filesystem::path& path, RecorderOptions options)
      : recorder_(path, std::move(options)) {}

  void connect(const std::vector<const OutputEnd*>& outputs) override;
  void on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) override;
  /// It records what is sent, and has nothing made that nobody else reads: drawings made the planner's cycle
  /// longer.
  [[nodiscard]] bool wants_everything() const override { return false; }
  void run_is_over() override { messages_of_run_ = recorder_.status().recorded; }

  Recorder& recorder() { return recorder_; }
  /// Messages recorded before the components were deactivated.
  [[nodiscard]] std::uint64_t messages_of_run() const { return messages_of_run_; }

 private:
  struct Topic {
    std::size_t number = 0;
    bool has_stamp = false;
  };
  Recorder recorder_;
  std::map<const OutputEnd*, Topic> topics_;
  std::uint64_t messages_of_run_ = 0;
};

}  // namespace bw::bag
