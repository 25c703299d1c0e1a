#include "components/program/record_options.hpp"

#include <stdexcept>

namespace bw {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& value, const std::string& rule) {
  throw std::runtime_error(option + " " + value + ": " + rule);
}

}  // namespace

void RecordOptions::add_to(cli::Verb verb) {
  verb.option("--record", record, "Records every message: a new folder, or a file.mcap");
  writing.add_to(verb);
  verb.option(
      "--snapshot", snapshot,
      "Keeps so much of the last time in memory, such as 30s, and writes it when something happens; off: does not");
  verb.option("--snapshot-memory", snapshot_memory, "At most so much of it (256MB)");
  verb.option("--snapshot-on", snapshot_on,
              "Events and topics to wait for, as often as needed (every known event)")
      .one_each_time();
  verb.option("--snapshot-to", snapshot_to, "Folder for snapshots (snapshots)");
}

bag::BagWriterOptions RecordOptions::writer_options() const {
  if (writing.splits() && record.empty())
    throw std::runtime_error("--split-size, --split-duration and --max-size need --record");
  return writing.options(record);
}

void RecordOptions::apply_to(std::optional<SnapshotSettings>& settings) const {
  if (snapshot == "off") {
    settings.reset();
    return;
  }
  if (!settings && snapshot.empty()) {
    if (snapshot_memory.empty() && snapshot_on.empty() && snapshot_to.empty()) return;
    throw std::runtime_error(
        "--snapshot-memory, --snapshot-on and --snapshot-to need --snapshot, or a section snapshot in the graph");
  }
  if (!settings) settings.emplace(SnapshotSettings{.where = {"--snapshot", 0}});
  if (!snapshot.empty()) {
    settings->keep = cli::duration_option("--snapshot", snapshot);
    if (settings->keep > SnapshotSettings::kLongest)
      refuse("--snapshot", snapshot, "must be at most an hour");
    settings->after.reset();
  }
  if (!snapshot_memory.empty())
    settings->memory = cli::size_option("--snapshot-memory", snapshot_memory, SnapshotSettings::kLeastMemory);
  if (!snapshot_to.empty()) settings->to = snapshot_to;
  if (snapshot_on.empty()) return;
  settings->on.clear();
  std::vector<Violation> violations;
  for (const std::string& text : snapshot_on) {
    if (auto event = snapshot_event(text, {"--snapshot-on", 0}, "snapshot.on", violations))
      settings->on.push_back(std::move(*event));
  }
  throw_if_any(std::move(violations));
}

}  // namespace bw
