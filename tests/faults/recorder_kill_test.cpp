// The recorder's process is killed while it records 20 MB/s (rows 20 and 21): what is left opens without
// repair, whole up to what was flushed; and so does what would be left of it after a power cut at that
// moment, whole up to what was synced.
//
//   BANDWAGON_RECORDER_KILLS=300 [BANDWAGON_RECORDER_SEED=N] test_recorder_kill
//
// does so 300 times, and 30 times at 0.2 MB/s, prints the seed and what was lost, and asserts the limits in
// seconds: 1 after a kill, 2 after a power cut.
// Without it a few kills, and no clock is asked.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/timerfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime/recording/bag/recorder.hpp"
#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::bag {
namespace {

constexpr std::size_t kLarge = 20'000;  // [bytes] of a message; a thousand of them each second are 20 MB/s
constexpr std::size_t kSmall = 200;     // so that no chunk is ever full
constexpr double kMaxLostByKill = 1.0;  // [s]
constexpr double kMaxLostByPowerCut = 2.0;  // [s]

/// What the child tells while it lives.
struct Shared {
  std::atomic<std::uint64_t> sent = 0;   ///< messages given to the recorder
  std::atomic<std::int64_t> newest = 0;  ///< time of the last of them [ns]
  std::atomic<std::uint64_t> flushed = 0;
  std::atomic<std::uint64_t> dropped = 0;
  std::atomic<std::uint64_t> synced_size = 0;  ///< of the file [bytes]

  std::atomic<std::int64_t> longest_sync = 0;  ///< [ns]
};

std::int64_t now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time).count();
}

/// Number, then what follows from it: half of it noise, which no compression shrinks.
Bytes content(std::uint64_t number, std::size_t size) {
  Bytes bytes(size);
  std::memcpy(bytes.data(), &number, sizeof(number));
  std::uint64_t noise = number * 0x9E3779B97F4A7C15ULL + 1;
  for (std::size_t i = sizeof(number); i + sizeof(noise) <= size / 2; i += sizeof(noise)) {
    noise = noise * 6364136223846793005ULL + 1442695040888963407ULL;
    std::memcpy(bytes.data() + i, &noise, sizeof(noise));
  }
  return bytes;
}

class WatchedFile final : public ByteSink {
 public:
  WatchedFile(std::unique_ptr<ByteSink> file, Shared& shared) : file_(std::move(file)), shared_(shared) {}
  void write(BytesView bytes) override { file_->write(bytes); }
  void sync() override {
    const std::uint64_t size = file_->size();
    const std::int64_t began = now();
    file_->sync();
    shared_.synced_size = size;
    shared_.longest_sync = std::max(shared_.longest_sync.load(), now() - began);
  }
  std::uint64_t size() const override { return file_->size(); }

 private:
  std::unique_ptr<ByteSink> file_;
  Shared& shared_;
};

/// Never returns. A byte goes into `clock` with every message.
[[noreturn]] void record_until_killed(const std::filesystem::path& file, std::size_t size, Shared& shared,
                                      int clock) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  RecorderOptions options;
  options.writer.create = [&](const auto& path) {
    return std::make_unique<WatchedFile>(create_file(path), shared);
  };
  Recorder recorder(file, options);
  const std::size_t topic = recorder.add_topic({.name = "/noise",
                                                .type = "std_msgs/msg/String",
                                                .schema_encoding = "ros2msg",
                                                .schema_text = "string data\n"});
  const int timer = timerfd_create(CLOCK_MONOTONIC, 0);
  const itimerspec each_millisecond{.it_interval = {0, 1'000'000}, .it_value = {0, 1'000'000}};
  timerfd_settime(timer, 0, &each_millisecond, nullptr);
  for (std::uint64_t number = 0;;) {
    std::uint64_t due = 0;
    if (read(timer, &due, sizeof(due)) != sizeof(due)) _exit(1);
    for (; due > 0; --due, ++number) {
      const Bytes bytes = content(number, size);
      const std::int64_t time = now();
      recorder.record(topic, {time}, {time}, bytes);
      shared.newest = time;
      shared.sent = number + 1;
      if (::write(clock, "", 1) != 1) _exit(1);
    }
    const RecorderStatus status = recorder.status();
    shared.flushed = status.flushed;
    shared.dropped = status.dropped.empty() ? 0 : status.dropped.begin()->second;
  }
}

struct Left {
  std::uint64_t count = 0;    ///< messages, all of them sound and in order
  std::int64_t first = 0;     ///< [ns]
  std::int64_t newest = 0;    ///< [ns]
  std::uint64_t missing = 0;  ///< before the last one
};

/// Reads what is left, without repair.
Left read(const std::filesystem::path& file, std::size_t size) {
  Left left;
  const auto bag = open_bag(file);
  // It was not closed, and its last record may be cut.
  for (const BagFault& fault : bag->faults())
    EXPECT_THAT(fault.what, testing::AnyOf(testing::HasSubstr("not closed"),
                                           testing::HasSubstr("more than the file holds")));
  const auto messages = bag->messages({});
  BagMessage message;
  Step step = messages->next(message);
  for (std::uint64_t next = 0; step == Step::message; step = messages->next(message)) {
    std::uint64_t number = 0;
    if (message.data.size() != size) {
      ADD_FAILURE() << "a message of " << message.data.size() << " bytes";
      break;
    }
    std::memcpy(&number, message.data.data(), sizeof(number));
    EXPECT_GE(number, next);
    EXPECT_EQ(std::memcmp(content(number, size).data(), message.data.data(), size), 0) << number;
    left.missing += number - next;
    next = number + 1;
    if (left.count++ == 0) left.first = message.log_time.nanoseconds;
    left.newest = message.log_time.nanoseconds;
  }
  EXPECT_EQ(step, Step::end) << messages->fault().what;
  return left;
}

/// Bytes that come through a pipe until so many came or its other end is gone.
std::uint64_t wait_for(int pipe, std::uint64_t count) {
  std::array<char, 64> buffer{};
  std::uint64_t seen = 0;
  while (seen < count) {
    const ssize_t got = ::read(pipe, buffer.data(), std::min<std::size_t>(buffer.size(), count - seen));
    if (got <= 0) break;
    seen += static_cast<std::uint64_t>(got);
  }
  return seen;
}

struct Lost {
  double by_kill = 0.0;       ///< [s]
  double by_power_cut = 0.0;  ///< [s]
  double longest_sync = 0.0;  ///< [s]
  std::uint64_t dropped = 0;
};

Lost kill_after(const std::filesystem::path& file, std::size_t size, std::uint64_t messages) {
  void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto& shared = *new (memory) Shared;
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) throw std::runtime_error("no pipe");
  const std::int64_t began = now();
  const pid_t child = fork();
  if (child == 0) {
    close(pipe[0]);
    record_until_killed(file, size, shared, pipe[1]);
  }
  close(pipe[1]);
  EXPECT_EQ(wait_for(pipe[0], messages), messages) << "the recorder ended by itself";
  const std::uint64_t flushed = shared.flushed;
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(pipe[0]);

  const auto seconds = [&](const Left& left) {
    return 1e-9 * static_cast<double>(shared.newest - (left.count == 0 ? began : left.newest));
  };
  Lost lost{.longest_sync = 1e-9 * static_cast<double>(shared.longest_sync), .dropped = shared.dropped};
  const Left after_kill = read(file, size);
  EXPECT_GE(after_kill.count, flushed);
  EXPECT_LE(after_kill.missing, lost.dropped);
  lost.by_kill = seconds(after_kill);
  // The device keeps what was synced.
  if (shared.synced_size > 0) {
    std::filesystem::resize_file(file, shared.synced_size);
    const Left after_cut = read(file, size);
    EXPECT_LE(after_cut.count, after_kill.count);
    lost.by_power_cut = seconds(after_cut);
  }
  munmap(memory, sizeof(Shared));
  return lost;
}

std::uint64_t setting(const char* name, std::uint64_t fallback) {
  const char* text = std::getenv(name);
  return text == nullptr ? fallback : std::strtoull(text, nullptr, 10);
}

void kill_often(std::size_t size, std::uint64_t kills, bool is_measured) {
  const std::uint64_t seed = setting("BANDWAGON_RECORDER_SEED", 1);
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::uint64_t> messages(100, 4000);
  Lost worst;
  for (std::uint64_t i = 0; i < kills; ++i) {
    const mcap::Folder folder;
    const std::uint64_t count = messages(random);
    const Lost lost = kill_after(folder / "drive.mcap", size, count);
    if (is_measured) {
      EXPECT_LE(lost.by_kill, kMaxLostByKill) << "kill " << i << " after " << count << " messages";
      EXPECT_LE(lost.by_power_cut, kMaxLostByPowerCut) << "kill " << i << " after " << count << " messages";
    }
    worst = {std::max(worst.by_kill, lost.by_kill), std::max(worst.by_power_cut, lost.by_power_cut),
             std::max(worst.longest_sync, lost.longest_sync), worst.dropped + lost.dropped};
  }
  fmt::print(
      "{} kills at random times, seed {}, {} bytes a millisecond: at most {:.3f} s lost by a kill, {:.3f} s by a power cut; "
      "longest sync {:.3f} s, {} messages dropped\n",
      kills, seed, size, worst.by_kill, worst.by_power_cut, worst.longest_sync, worst.dropped);
}

const char* const kKills = "BANDWAGON_RECORDER_KILLS";

TEST(RecorderKill, LeavesABagThatOpensWithoutRepair) {
  kill_often(kLarge, setting(kKills, 3), std::getenv(kKills) != nullptr);
}

TEST(RecorderKill, LeavesOneWhereNoChunkIsFull) {
  kill_often(kSmall, std::max<std::uint64_t>(setting(kKills, 20) / 10, 2), std::getenv(kKills) != nullptr);
}

}  // namespace
}  // namespace bw::bag
