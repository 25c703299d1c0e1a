#include "components/lab/bench/bag_reading.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "components/lab/bench/bench_common.hpp"
#include "runtime/process_memory.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw {
namespace {

using Clock = std::chrono::steady_clock;
using nlohmann::ordered_json;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Asks the system to forget what it keeps of the files, once they are on the disk.
void drop_cache(const std::filesystem::path& bag) {
  const auto drop = [](const std::filesystem::path& file) {
    const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    static_cast<void>(fdatasync(descriptor));
    static_cast<void>(posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED));
    close(descriptor);
  };
  if (!std::filesystem::is_directory(bag)) return drop(bag);
  for (const auto& entry : std::filesystem::directory_iterator(bag)) drop(entry.path());
}

std::vector<double> seek(const bag::Bag& recording, const std::filesystem::path& path, int count,
                         std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::int64_t span = std::max<std::int64_t>((recording.end() - recording.start()).nanoseconds, 1);
  std::vector<double> seconds;
  for (int i = 0; i < count; ++i) {
    const Time to =
        recording.start() + Duration{static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(span))};
    drop_cache(path);
    const auto start = Clock::now();
    bag::BagMessage message;
    if (recording.messages({.start = to})->next(message) != bag::Step::message)
      throw std::runtime_error(path.string() + ": no message where one should be");
    seconds.push_back(seconds_since(start));
  }
  std::ranges::sort(seconds);
  return seconds;
}

}  // namespace

ordered_json read_figures(const std::filesystem::path& path, int seeks, std::uint64_t seed) {
  const double memory_before = memory_mb();
  drop_cache(path);
  auto start = Clock::now();
  const auto recording = bag::open_bag(path);
  const double open_s = seconds_since(start);
  const double memory_open = memory_mb();
  std::printf("open        %.1f ms, %.1f MB of memory (%.1f MB before)\n", 1e3 * open_s, memory_open,
              memory_before);
  ordered_json figures = {
      {"open_s", open_s}, {"rss_before", 1e6 * memory_before}, {"rss_open", 1e6 * memory_open}};
  if (recording->message_count() == 0) return figures;

  const std::vector<double> times = seek(*recording, path, seeks, seed);
  if (!times.empty()) {
    std::printf("seek        %.2f ms median, %.2f ms worst of %d random times\n",
                1e3 * times[times.size() / 2], 1e3 * times.back(), seeks);
    figures["seek_median_s"] = times[times.size() / 2];
    figures["seek_worst_s"] = times.back();
  }

  drop_cache(path);
  start = Clock::now();
  double bytes = 0.0;
  std::uint64_t messages = 0;
  const auto all = recording->messages({});
  bag::BagMessage message;
  for (bag::Step step = all->next(message); step != bag::Step::end; step = all->next(message)) {
    if (step == bag::Step::damaged) continue;
    bytes += static_cast<double>(message.data.size());
    ++messages;
  }
  const double read_s = seconds_since(start);
  std::printf("read        %.0f MB/s of messages, %.0f messages/s, %.1f MB of memory at most\n",
              1e-6 * bytes / read_s, static_cast<double>(messages) / read_s, peak_memory_mb());
  figures["read_mb_per_s"] = 1e-6 * bytes / read_s;
  figures["read_messages_per_s"] = static_cast<double>(messages) / read_s;
  figures["rss_most"] = 1e6 * peak_memory_mb();
  return figures;
}

ordered_json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return ordered_json::parse(in);
}

}  // namespace bw
