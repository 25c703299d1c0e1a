#include "components/program/recording.hpp"

#include <utility>

#include <fmt/format.h>

namespace bw {
namespace {

/// Counts by topic are values on the diagnostics, and in the bag.
std::string in_words(const bag::RecorderStatus& status) {
  std::string words = status.error.empty() ? "" : "the recording ended early: " + status.error;
  if (status.dropped.empty()) return words;
  std::uint64_t sum = 0;
  for (const auto& [topic, count] : status.dropped) sum += count;
  const std::string topics = status.dropped.size() == 1 ? status.dropped.begin()->first
                                                        : fmt::format("{} topics", status.dropped.size());
  return words +
         fmt::format("{}{} messages of {} are not in the recording", words.empty() ? "" : "; ", sum, topics);
}

class RecordingReporter final : public Component {
 public:
  explicit RecordingReporter(std::shared_ptr<std::shared_ptr<bag::RunRecorder>> recorder)
      : recorder_(std::move(recorder)) {}

  void configure(Setup& setup) override {
    DiagnosticReporter& diagnostics = setup.diagnostics();
    setup.every(Duration::milliseconds(1000), "report", [this, &diagnostics, log = setup.log()](const Tick&) {
      const bag::RecorderStatus status = (*recorder_)->recorder().status();
      const std::string words = in_words(status);
      diagnostics.set_value("messages", std::to_string(status.recorded));
      diagnostics.set_value("bytes", std::to_string(status.size));
      for (const auto& [topic, count] : status.dropped)
        diagnostics.set_value("dropped " + topic, std::to_string(count));
      if (words.empty()) {
        diagnostics.report(DiagnosticReporter::Level::ok, "recording");
        return;
      }
      diagnostics.report(
          status.error.empty() ? DiagnosticReporter::Level::warn : DiagnosticReporter::Level::error, words);
      if (!std::exchange(has_complained_, true)) log.warn("{}", words);
    });
  }

 private:
  std::shared_ptr<std::shared_ptr<bag::RunRecorder>> recorder_;
  bool has_complained_ = false;
};

}  // namespace

std::unique_ptr<Component> Recording::make_reporter() const {
  return std::make_unique<RecordingReporter>(recorder_);
}

std::shared_ptr<SampleTap> Recording::open(const std::filesystem::path& path, bag::RecorderOptions options,
                                           const bag::BagDescription& description) {
  *recorder_ = std::make_shared<bag::RunRecorder>(path, std::move(options));
  bag::Recorder& recorder = (*recorder_)->recorder();
  for (const auto& a : description.attachments) recorder.attach(a.name, a.media_type, a.content, {});
  for (const auto& [name, entries] : description.metadata) recorder.add_metadata(name, entries);
  return *recorder_;
}

std::string Recording::finish(const Host& host) {
  bag::RunRecorder& run = **recorder_;
  std::map<std::string, std::string> result = {{"messages_of_run", std::to_string(run.messages_of_run())}};
  if (std::string hash = host.samples_sha256(); !hash.empty()) result["samples_sha256"] = std::move(hash);
  run.recorder().add_metadata("result", result);
  run.recorder().close();
  return in_words(run.recorder().status());
}

nlohmann::json Recording::json() const {
  const bag::RecorderStatus status = (*recorder_)->recorder().status();
  return {{"messages", status.recorded},
          {"bytes", status.size},
          {"dropped", status.dropped},
          {"error", status.error},
          {"cpu_s", status.cpu_time.to_seconds()}};
}

}  // namespace bw
