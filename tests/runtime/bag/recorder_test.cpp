// The recorder's promises: in order, never in the way, and honest about what it lost.
#include "runtime/bag/recorder.hpp"

#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <system_error>

#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/runtime/bag/mcap_files.hpp"

namespace bw::bag {
namespace {

using ::testing::Pair;
using ::testing::UnorderedElementsAre;

BagTopic topic(const std::string& name) {
  return {.name = name,
          .type = "std_msgs/msg/String",
          .schema_encoding = "ros2msg",
          .schema_text = "string data\n"};
}

std::vector<std::int64_t> times(const std::filesystem::path& path) {
  const auto bag = open_bag(path);
  std::vector<std::int64_t> out;
  const auto messages = bag->messages({});
  for (BagMessage m; messages->next(m) == Step::message;) out.push_back(m.log_time.nanoseconds);
  return out;
}

std::vector<std::int64_t> up_to(std::int64_t count) {
  std::vector<std::int64_t> all;
  for (std::int64_t i = 0; i < count; ++i) all.push_back(i);
  return all;
}

/// A disk that does not answer until it is told to.
class StuckDisk final : public ByteSink {
 public:
  struct Gate {
    std::mutex mutex;
    std::condition_variable changed;
    bool open = true;
    bool waits = false;
    void set(bool to) {
      const std::lock_guard lock(mutex);
      open = to;
      changed.notify_all();
    }
    void pass() {
      std::unique_lock lock(mutex);
      waits = true;
      changed.notify_all();
      changed.wait(lock, [this] { return open; });
      waits = false;
    }
    void wait_until_stuck() {
      std::unique_lock lock(mutex);
      changed.wait(lock, [this] { return waits; });
    }
  };
  StuckDisk(std::unique_ptr<ByteSink> file, std::shared_ptr<Gate> gate)
      : file_(std::move(file)), gate_(std::move(gate)) {}
  void write(BytesView bytes) override {
    gate_->pass();
    file_->write(bytes);
  }
  void sync() override { file_->sync(); }
  std::uint64_t size() const override { return file_->size(); }

 private:
  std::unique_ptr<ByteSink> file_;
  std::shared_ptr<Gate> gate_;
};

TEST(Recorder, WritesEverythingInOrder) {
  const mcap::Folder folder;
  for (const bool waits : {false, true}) {
    const std::filesystem::path path = folder / (waits ? "a.mcap" : "b.mcap");
    Recorder recorder(path, {.waits = waits});
    const std::size_t a = recorder.add_topic(topic("/a"));
    for (std::int64_t i = 0; i < 1000; ++i) recorder.record(a, {i}, {i}, mcap::as_bytes("text"));
    recorder.close();
    EXPECT_EQ(recorder.status().recorded, 1000U);
    EXPECT_TRUE(recorder.status().dropped.empty());
    EXPECT_EQ(times(path), up_to(1000));
  }
}

TEST(Recorder, DropsAndCountsWhileTheDiskIsStuck) {
  const mcap::Folder folder;
  auto gate = std::make_shared<StuckDisk::Gate>();
  const std::string megabyte(1'000'000, 'm');
  RecorderOptions options{.queue_size = 2'500'000};
  options.writer.compression = Compression::none;
  options.writer.create = [gate](const std::filesystem::path& file) {
    return std::make_unique<StuckDisk>(create_file(file), gate);
  };
  Recorder recorder(folder / "a.mcap", options);
  const std::size_t a = recorder.add_topic(topic("/a"));
  const std::size_t b = recorder.add_topic(topic("/b"));
  gate->set(false);
  // The second one closes the first one's chunk, and the writing thread is stuck with both.
  for (std::int64_t i = 0; i < 2; ++i) recorder.record(a, {i}, {i}, mcap::as_bytes(megabyte));
  gate->wait_until_stuck();
  // Two fit into the queue.
  for (std::int64_t i = 2; i < 5; ++i) recorder.record(b, {i}, {i}, mcap::as_bytes(megabyte));
  EXPECT_THAT(recorder.status().dropped, UnorderedElementsAre(Pair("/b", 1U)));
  EXPECT_EQ(recorder.status().recorded, 4U);
  gate->set(true);
  recorder.close();
  EXPECT_EQ(times(folder / "a.mcap"), up_to(4));
  EXPECT_EQ(open_bag(folder / "a.mcap")->metadata().at("dropped").at("/b"), "1");
}

TEST(Recorder, SaysWhenTheDiskFailsAndGoesOnCounting) {
  class FullDisk final : public ByteSink {
   public:
    void write(BytesView bytes) override {
      if (size_ + bytes.size() > 4000) throw std::system_error(ENOSPC, std::generic_category(), "disk");
      size_ += bytes.size();
    }
    void sync() override {}
    std::uint64_t size() const override { return size_; }

   private:
    std::uint64_t size_ = 0;
  };
  const mcap::Folder folder;
  RecorderOptions options{.waits = true};
  options.writer.compression = Compression::none;
  options.writer.split_size = 0;
  options.writer.create = [](const std::filesystem::path&) { return std::make_unique<FullDisk>(); };
  Recorder recorder(folder / "a.mcap", options);
  const std::size_t a = recorder.add_topic(topic("/a"));
  const std::string megabyte(1'000'000, 'm');
  for (std::int64_t i = 0; i < 5; ++i) recorder.record(a, {i}, {i}, mcap::as_bytes(megabyte));
  const RecorderStatus status = recorder.status();
  EXPECT_THAT(status.error, ::testing::HasSubstr("No space left"));
  // The first message waits in the open chunk; the second one closes it and meets the full disk.
  EXPECT_EQ(status.recorded, 1U);
  EXPECT_THAT(status.dropped, UnorderedElementsAre(Pair("/a", 4U)));
  recorder.close();
  EXPECT_FALSE(recorder.status().error.empty());
}

}  // namespace
}  // namespace bw::bag
