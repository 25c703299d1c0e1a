#include "components/program/snapshots.hpp"

#include <chrono>
#include <ctime>
#include <stdexcept>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <std_msgs/msg/string.hpp>
#include <unistd.h>

#include "components/program/bag_description.hpp"
#include "runtime/recording/bag/snapshot_events.hpp"

namespace bw {
namespace {

constexpr const char* kTopic = "/snapshot";

/// By the calendar where the clock has one: 2026-11-22T06-20-59Z. A process of several adds its name.
std::string name_of(Time time, ClockMode clock, const std::string& process) {
  const std::string suffix = process.empty() ? "" : "_" + process;
  if (clock != ClockMode::wall) return fmt::format("{:010.3f}{}", time.to_seconds(), suffix);
  const auto seconds = static_cast<std::time_t>(time.nanoseconds / 1'000'000'000);
  return fmt::format("{:%Y-%m-%dT%H-%M-%S}Z{}", fmt::gmtime(seconds), suffix);
}

/// Without making anything: nothing is left behind by a drive in which nothing happens.
void check_writable(const SnapshotSettings& settings) {
  std::filesystem::path folder = std::filesystem::absolute(settings.to);
  while (!std::filesystem::exists(folder)) folder = folder.parent_path();
  if (std::filesystem::is_directory(folder) && access(folder.c_str(), W_OK | X_OK) == 0) return;
  throw ConfigError({.where = settings.where,
                     .key = "snapshot.to",
                     .value = settings.to.string(),
                     .rule = folder.string() + " is no folder that can be written"});
}

class SnapshotReporter final : public Component {
 public:
  SnapshotReporter(std::shared_ptr<std::shared_ptr<bag::FlightRecorder>> recorder,
                   std::shared_ptr<std::size_t> told, std::string process)
      : recorder_(std::move(recorder)), told_(std::move(told)), process_(std::move(process)) {}

  void configure(Setup& setup) override {
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    if (!process_.empty()) others_ = setup.output<std_msgs::msg::String>(kTopic);
    setup.input<std_msgs::msg::String>(
        kTopic, Qos::standard(), [this](const auto& message, const Tick&) { on_event(message.data()); },
        Need::optional);
    setup.every(Duration::milliseconds(200), "report", [this](const Tick&) { report(); });
  }

 private:
  void on_event(const std::string& text) {
    const std::size_t at = text.find('@');
    if (at == std::string::npos || text.substr(at + 1) != process_)
      (*recorder_)->trigger(at == 0 || text.empty() ? "outside" : text.substr(0, at));
  }

  void report() {
    const bag::FlightRecorderStatus status = (*recorder_)->status();
    for (; *told_ < status.log.size(); ++*told_) log_.warn("{}", status.log[*told_]);
    for (const std::string& event : (*recorder_)->take_events()) {
      if (process_.empty()) continue;
      std_msgs::msg::String message;
      message.data(event + "@" + process_);
      others_.publish(message);
    }
    diagnostics_->set_value("seconds", fmt::format("{:.1f}", status.kept.to_seconds()));
    diagnostics_->set_value("memory", std::to_string(status.memory));
    diagnostics_->set_value("snapshots", std::to_string(status.snapshots));
    diagnostics_->set_value("lost", std::to_string(status.lost));
    using Level = DiagnosticReporter::Level;
    if (!status.error.empty())
      return diagnostics_->report(Level::error, "the snapshot ended early: " + status.error);
    if (status.lost + status.oversized + status.unwritten == 0)
      return diagnostics_->report(Level::ok, "keeps the last seconds");
    diagnostics_->report(Level::warn, fmt::format("{} messages lost, {} too large, {} events not written",
                                                  status.lost, status.oversized, status.unwritten));
  }

  std::shared_ptr<std::shared_ptr<bag::FlightRecorder>> recorder_;
  std::shared_ptr<std::size_t> told_;
  std::string process_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  Output<std_msgs::msg::String> others_;
};

}  // namespace

std::unique_ptr<Component> Snapshots::make_reporter(const std::string& process) const {
  return std::make_unique<SnapshotReporter>(recorder_, told_, process);
}

std::shared_ptr<SampleTap> Snapshots::open(const Graph& graph, const Host& host, const HostOptions& options,
                                           bag::BagDescription description) {
  const SnapshotSettings& settings = *graph.snapshot;
  check_writable(settings);
  bag::FlightRecorderOptions recorder;
  recorder.ring = {.keep = settings.keep, .memory = settings.memory};
  recorder.after = settings.after.value_or(settings.keep);
  recorder.most = settings.most;
  recorder.folder = settings.to;
  recorder.events = bag::resolve_events(settings, graph, host.declarations());
  recorder.writer.ros_distro = ros_distro_of(graph);
  recorder.waits = options.clock == ClockMode::lockstep;
  recorder.name_of = [clock = options.clock, process = options.only_process](Time time) {
    return name_of(time, clock, process);
  };
  *recorder_ = std::make_shared<bag::FlightRecorder>(std::move(recorder));
  (*recorder_)->describe(std::move(description));
  return *recorder_;
}

std::string Snapshots::untold() const {
  const bag::FlightRecorderStatus status = (*recorder_)->status();
  std::string text;
  for (; *told_ < status.log.size(); ++*told_) text += status.log[*told_] + "\n";
  if (status.unwritten > 0)
    text += fmt::format("{} more events got no snapshot: there are {} of them\n", status.unwritten,
                        status.snapshots);
  return text;
}

nlohmann::json Snapshots::json() const {
  const bag::FlightRecorderStatus status = (*recorder_)->status();
  return {{"written", status.snapshots},
          {"log", status.log},
          {"lost", status.lost},
          {"error", status.error},
          {"unwritten", status.unwritten}};
}

}  // namespace bw
