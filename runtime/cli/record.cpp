// bandwagon record [TOPIC...]: topics of any running ROS 2 system into a bag. Exit status 1 when the disk failed or was
// too slow, 2 on a wrong use.
#include <chrono>
#include <ctime>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include <CLI/App.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include "runtime/cli/regex_option.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/terminal.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/record/wire_recorder.hpp"

namespace bw::cli {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

struct RecordOptions {
  record::TopicChoiceOptions choice;
  std::string exclude;
  std::string out;
  std::string compression = "zstd";
  std::uint64_t split_size = 0;
  std::string split_duration;
  std::uint64_t max_size = 0;
  std::uint64_t cache_size = std::uint64_t{100} << 20;
  double for_s = 0.0;
  bool use_sim_time = false;
};

/// As `ros2 bag record` names it, by the local time.
std::string dated_folder() {
  return fmt::format("rosbag2_{:%Y_%m_%d-%H_%M_%S}", fmt::localtime(std::time(nullptr)));
}

Duration split_duration(const std::string& text) {
  if (text.empty()) return {};
  const std::optional<Duration> duration = parse_duration(text);
  if (!duration || *duration < Duration::milliseconds(1000))
    throw std::runtime_error("--split-duration " + text +
                             ": must be a duration of at least 1 s, such as 60 or 10min");
  return *duration;
}

bag::RecorderOptions recorder_options(const RecordOptions& options) {
  bag::RecorderOptions out{.queue_size = options.cache_size};
  out.writer.compression = options.compression == "none" ? bag::Compression::none
                                                         : bag::compression_of(options.compression).value();
  out.writer.split_size = options.split_size;
  out.writer.split_duration = split_duration(options.split_duration);
  out.writer.max_size = options.max_size;
  // What is deleted are whole files.
  if (options.max_size > 0 && options.split_size == 0 && options.split_duration.empty())
    out.writer.split_size = options.max_size / 4;
  return out;
}

std::uint64_t sum_of(const std::map<std::string, std::uint64_t>& counts) {
  std::uint64_t sum = 0;
  for (const auto& [topic, count] : counts) sum += count;
  return sum;
}

std::string in_words(const record::WireRecorderStatus& status, double seconds) {
  std::string words = fmt::format("{:.1f} s | {} topics | {} messages | {:.2f} MB", seconds, status.topics,
                                  status.bag.recorded, static_cast<double>(status.bag.size) * 1e-6);
  words += fmt::format(" | dropped {} | lost {}", sum_of(status.bag.dropped), sum_of(status.lost));
  return words;
}

int run_record(const RecordOptions& options) {
  const std::filesystem::path out = options.out.empty() ? dated_folder() : options.out;
  const bool is_split = options.split_size > 0 || !options.split_duration.empty() || options.max_size > 0;
  if (is_split && out.extension() == ".mcap")
    throw std::runtime_error(out.string() +
                             " is one file: --split-size, --split-duration and --max-size need a folder");
  record::TopicChoiceOptions choice = options.choice;
  choice.exclude = to_regex("--exclude", options.exclude);
  catch_interrupts();
  record::WireRecorder recorder(out, {.choice = std::move(choice),
                                      .network = dds::Network::from_environment(dds::Transport::localhost),
                                      .use_sim_time = options.use_sim_time,
                                      .recorder = recorder_options(options)});
  const auto start = steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(steady_clock::now() - start).count(); };
  {
    ProgressLine line;
    line.show("recording to " + out.string() + ", Ctrl-C ends it");
    while (!interrupted() && (options.for_s <= 0.0 || seconds() < options.for_s)) {
      std::this_thread::sleep_for(100ms);
      const record::WireRecorderStatus status = recorder.status();
      line.show(in_words(status, seconds()));
      if (!status.bag.error.empty()) break;
    }
  }
  const double recorded_s = seconds();
  recorder.close();
  const record::WireRecorderStatus status = recorder.status();
  std::cout << fmt::format("{}: {}\n", out.string(), in_words(status, recorded_s));
  for (const auto& [topic, count] : status.bag.dropped)
    std::cout << fmt::format("dropped: {} messages of {} came faster than the disk takes them\n", count,
                             topic);
  for (const auto& [topic, count] : status.lost)
    std::cout << fmt::format("lost: {} messages of {} were sent and did not arrive\n", count, topic);
  if (!status.bag.error.empty()) std::cerr << "the recording ended early: " << status.bag.error << "\n";
  return status.bag.error.empty() && status.bag.dropped.empty() ? 0 : 1;
}

CLI::App* add_record(CLI::App& app, int& status) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* verb = app.add_subcommand("record", "Records topics of a running ROS 2 system, of any type");
  verb->add_option("TOPIC", options->choice.topics, "Topics, also ones that appear later");
  verb->add_flag("-a,--all", options->choice.all, "Every topic but hidden ones");
  verb->add_flag("--include-hidden-topics", options->choice.hidden,
                 "With --all: those with a _ before a token as well");
  verb->add_option("-x,--exclude", options->exclude,
                   "With --all or --node: not what this regular expression finds");
  verb->add_option("--node", options->choice.nodes,
                   "All topics that this node writes or reads, as often as needed")
      ->allow_extra_args(false);
  verb->add_option("-o,--out", options->out,
                   "New folder, or a file.mcap; rosbag2_ and the date if not given");
  verb->add_option("-b,--split-size", options->split_size, "A new file beyond this, such as 500MB")
      ->transform(CLI::AsSizeValue(true));
  verb->add_option("-d,--split-duration", options->split_duration,
                   "A new file after this time, such as 60 (seconds) or 10min");
  verb->add_option("--max-size", options->max_size, "Of all files; the oldest are deleted, such as 2GB")
      ->transform(CLI::AsSizeValue(true));
  verb->add_option("--max-cache-size", options->cache_size, "Of messages that wait for the disk (100 MiB)")
      ->transform(CLI::AsSizeValue(true));
  verb->add_option("--compression", options->compression, "zstd, lz4 or none")
      ->check(CLI::IsMember({"zstd", "lz4", "none"}));
  verb->add_option("--for", options->for_s, "Ends after so many seconds")->check(CLI::PositiveNumber);
  verb->add_flag("--use-sim-time", options->use_sim_time, "Times of the bag from /clock");
  verb->callback([options, &status] { status = run_record(*options); });
  return verb;
}

}  // namespace

BW_VERB(drive, "record", add_record)

}  // namespace bw::cli
