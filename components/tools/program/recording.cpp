#include "components/tools/program/recording.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "runtime/build_identity.hpp"

namespace bw {
namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string parameters_of(const Host& host) {
  std::string text;
  for (const auto& [name, report] : host.parameters()) {
    text += name + ":\n";
    std::istringstream lines(report.yaml);
    for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
  }
  return text;
}

std::string in_words(const bag::RecorderStatus& status) {
  std::string words = status.error.empty() ? "" : "the recording ended early: " + status.error;
  for (const auto& [topic, count] : status.dropped) {
    words +=
        fmt::format("{}{} messages of {} are not in the recording", words.empty() ? "" : "; ", count, topic);
  }
  return words;
}

class RecordingReporter final : public Component {
 public:
  explicit RecordingReporter(std::shared_ptr<bag::RunRecorder> recorder) : recorder_(std::move(recorder)) {}

  void configure(Setup& setup) override {
    DiagnosticReporter& diagnostics = setup.diagnostics();
    setup.every(Duration::milliseconds(1000), "report", [this, &diagnostics, log = setup.log()](const Tick&) {
      const bag::RecorderStatus status = recorder_->recorder().status();
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
  std::shared_ptr<bag::RunRecorder> recorder_;
  bool has_complained_ = false;
};

}  // namespace

Recording::Recording(const std::filesystem::path& path, bool lockstep)
    : path_(path),
      recorder_(std::make_shared<bag::RunRecorder>(path, bag::RecorderOptions{.waits = lockstep})) {}

void Recording::describe(const Host& host, const HostOptions& options) {
  bag::Recorder& recorder = recorder_->recorder();
  recorder.attach("graph.yaml", "application/yaml", content_of(host.graph().path), {});
  recorder.attach("parameters.yaml", "application/yaml", parameters_of(host), {});
  constexpr const char* kClocks[] = {"wall", "lockstep", "topic"};
  recorder.add_metadata("bandwagon", {{"version", program_version()},
                                      {"revision", source_revision()},
                                      {"build_id", build_id()},
                                      {"cpu", cpu_type()},
                                      {"host", host_name()},
                                      {"clock", kClocks[static_cast<int>(options.clock)]},
                                      {"seed", std::to_string(options.seed)},
                                      {"process", options.only_process},
                                      {"graph", host.graph().path.string()}});
}

std::string Recording::finish(const Host& host) {
  std::map<std::string, std::string> result = {
      {"messages_of_run", std::to_string(recorder_->messages_of_run())}};
  if (std::string hash = host.samples_sha256(); !hash.empty()) result["samples_sha256"] = std::move(hash);
  recorder_->recorder().add_metadata("result", result);
  recorder_->recorder().close();
  return in_words(recorder_->recorder().status());
}

std::unique_ptr<Component> Recording::make_reporter() const {
  return std::make_unique<RecordingReporter>(recorder_);
}

}  // namespace bw
