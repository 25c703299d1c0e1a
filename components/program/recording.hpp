// The bag of a drive: every message its components send, and what one must know to drive it again.
#pragma once

#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "runtime/host/host.hpp"
#include "runtime/recording/bag/flight_recorder.hpp"
#include "runtime/recording/bag/run_recorder.hpp"

namespace bw {

class Recording {
 public:
  Recording() : recorder_(std::make_shared<std::shared_ptr<bag::RunRecorder>>()) {}

  /// Of drops and failures on the diagnostics: in real time only, so that in lock-step nothing of the
  /// recording enters a sample. To be made before the host, which takes it.
  [[nodiscard]] std::unique_ptr<Component> make_reporter() const;
  /// When the graph is known to be sound. Throws std::runtime_error or std::system_error naming `path`.
  [[nodiscard]] std::shared_ptr<SampleTap> open(const std::filesystem::path& path,
                                                bag::RecorderOptions options,
                                                const bag::BagDescription& description);
  /// Ends it. A sentence about what was lost, empty if nothing was.
  [[nodiscard]] std::string finish(const Host& host);
  /// Messages, bytes, drops, CPU time of the thread that writes.
  [[nodiscard]] nlohmann::json json() const;

 private:
  std::shared_ptr<std::shared_ptr<bag::RunRecorder>> recorder_;  ///< empty until open()
};

}  // namespace bw
