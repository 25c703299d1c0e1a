// The bag of a drive: every message its components send, and what one must know to drive it again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "runtime/bag/run_recorder.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/host/host.hpp"

namespace bw {

class Recording {
 public:
  /// Throws std::runtime_error or std::system_error naming `path`. In lock-step the run waits for the disk; nothing of
  /// the recording enters a sample.
  Recording(const std::filesystem::path& path, bool lockstep);

  std::shared_ptr<SampleTap> tap() const { return recorder_; }
  /// Attachments graph.yaml and parameters.yaml, metadata `bandwagon`.
  void describe(const Host& host, const HostOptions& options);
  /// Ends it. A sentence about what was lost, empty if nothing was.
  std::string finish(const Host& host);
  /// In real time: a component that tells the diagnostics of drops and failures.
  std::unique_ptr<Component> make_reporter() const;

 private:
  std::filesystem::path path_;
  std::shared_ptr<bag::RunRecorder> recorder_;
};

}  // namespace bw
