// bandwagon record [TOPIC...]: topics of any running ROS 2 system into a bag. Exit status 1 when the disk
// failed or was too slow, 2 on a wrong use.
#include <chrono>
#include <ctime>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "runtime/cli/bag_writing.hpp"
#include "runtime/cli/regex_option.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/terminal.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/host/service_manager.hpp"
#include "runtime/recording/record/wire_recorder.hpp"

namespace bw::cli {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

struct RecordOptions {
  record::TopicChoiceOptions choice;
  std::string exclude;
  std::string out;
  BagWriting writing;
  std::string cache_size = "100MiB";
  double for_s = 0.0;
  bool use_sim_time = false;
};

/// As `ros2 bag record` names it, by the local time.
std::string dated_folder() {
  return fmt::format("rosbag2_{:%Y_%m_%d-%H_%M_%S}", fmt::localtime(std::time(nullptr)));
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
  record::TopicChoiceOptions choice = options.choice;
  choice.exclude = to_regex("--exclude", options.exclude);
  catch_interrupts();
  record::WireRecorder recorder(
      out, {.choice = std::move(choice),
            .network = dds::Network::from_environment(dds::Transport::localhost),
            .use_sim_time = options.use_sim_time,
            .recorder = {.writer = options.writing.options(out),
                         .queue_size = size_option("--max-cache-size", options.cache_size, 1'000'000)}});
  const ServiceManager manager;
  manager.ready("recording to " + out.string());
  const auto start = steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(steady_clock::now() - start).count(); };
  {
    ProgressLine line;
    line.show("recording to " + out.string() + ", Ctrl-C ends it");
    while (!interrupted() && (options.for_s <= 0.0 || seconds() < options.for_s)) {
      std::this_thread::sleep_for(100ms);
      manager.alive();
      const record::WireRecorderStatus status = recorder.status();
      line.show(in_words(status, seconds()));
      if (!status.bag.error.empty()) break;
    }
  }
  const double recorded_s = seconds();
  manager.stopping("closing " + out.string(), true);
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

void add_record(Verb verb) {
  auto options = std::make_shared<RecordOptions>();
  verb.option("TOPIC", options->choice.topics, "Topics, also ones that appear later");
  verb.flag("-a,--all", options->choice.all, "Every topic but hidden ones");
  verb.flag("--include-hidden-topics", options->choice.hidden,
            "With --all: those with a _ before a token as well");
  verb.option("-x,--exclude", options->exclude,
              "With --all or --node: not what this regular expression finds");
  verb.option("--node", options->choice.nodes,
              "All topics that this node writes or reads, as often as needed")
      .one_each_time();
  verb.option("-o,--out", options->out, "New folder, or a file.mcap; rosbag2_ and the date if not given");
  options->writing.add_to(verb);
  verb.option("--max-cache-size", options->cache_size, "Of messages that wait for the disk (100MiB)");
  verb.option("--for", options->for_s, "Ends after so many seconds").positive();
  verb.flag("--use-sim-time", options->use_sim_time, "Times of the bag from /clock");
  verb.run([options] { return run_record(*options); });
}

}  // namespace

BW_VERB(drive, "record", "Records topics of a running ROS 2 system, of any type", add_record)

}  // namespace bw::cli
