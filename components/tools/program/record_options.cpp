#include "components/tools/program/record_options.hpp"

#include <filesystem>
#include <stdexcept>

#include "runtime/parameters/scalar_text.hpp"

namespace bw {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& value, const std::string& rule) {
  throw std::runtime_error(option + " " + value + ": " + rule);
}

/// 0 when it was not given.
std::uint64_t size_of(const std::string& option, const std::string& text, std::uint64_t least) {
  if (text.empty()) return 0;
  const std::optional<std::uint64_t> size = parse_size(text);
  if (!size || *size < least)
    refuse(option, text,
           "must be a size of at least " + std::to_string(least / 1'000'000) + "MB, such as 100MB or 2GiB");
  return *size;
}

Duration duration_of(const std::string& option, const std::string& text) {
  if (text.empty()) return {};
  const std::optional<Duration> duration = parse_duration(text);
  if (!duration || *duration < SnapshotSettings::kShortest)
    refuse(option, text, "must be a duration of at least 1 s, such as 30s or 10min");
  return *duration;
}

}  // namespace

void RecordOptions::add_to(CLI::App& verb) {
  verb.add_option("--record", record, "Records every message: a new folder, or a file.mcap");
  verb.add_option("--split-size", split_size, "Recording: a new file begins beyond this, such as 100MB");
  verb.add_option("--split-duration", split_duration, "Recording: or after this time, such as 10min");
  verb.add_option("--max-size", max_size, "Recording: the oldest files go, so that all stay below this");
  verb.add_option("--compression", compression, "Of the recording: zstd, lz4 or none")
      ->check(CLI::IsMember({"zstd", "lz4", "none"}));
  verb.add_option(
      "--snapshot", snapshot,
      "Keeps so much of the last time in memory, such as 30s, and writes it when something happens; off: does not");
  verb.add_option("--snapshot-memory", snapshot_memory, "At most so much of it (256MB)");
  verb.add_option("--snapshot-on", snapshot_on,
                  "Events and topics to wait for, as often as needed (every known event)")
      ->allow_extra_args(false);
  verb.add_option("--snapshot-to", snapshot_to, "Folder for snapshots (snapshots)");
}

bag::BagWriterOptions RecordOptions::writer_options() const {
  const bool splits = !split_size.empty() || !split_duration.empty() || !max_size.empty();
  if (splits && record.empty())
    throw std::runtime_error("--split-size, --split-duration and --max-size need --record");
  if (splits && std::filesystem::path(record).extension() == ".mcap")
    refuse("--record", record, "one file is not split: name a folder");
  bag::BagWriterOptions options{.split_size = size_of("--split-size", split_size, 1'000'000),
                                .split_duration = duration_of("--split-duration", split_duration),
                                .max_size = size_of("--max-size", max_size, 10'000'000)};
  if (options.max_size > 0 && options.split_size > options.max_size / 2)
    refuse("--split-size", split_size, "must be at most half of --max-size " + max_size);
  options.compression = compression == "none"  ? bag::Compression::none
                        : compression == "lz4" ? bag::Compression::lz4
                                               : bag::Compression::zstd;
  return options;
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
    settings->keep = duration_of("--snapshot", snapshot);
    if (settings->keep > SnapshotSettings::kLongest)
      refuse("--snapshot", snapshot, "must be at most an hour");
    settings->after.reset();
  }
  if (!snapshot_memory.empty())
    settings->memory = size_of("--snapshot-memory", snapshot_memory, SnapshotSettings::kLeastMemory);
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
