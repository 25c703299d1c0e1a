// The recorder's promises: in order, never in the way, and honest about what it lost.
#include "runtime/recording/bag/recorder.hpp"

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>

#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/runtime/recording/bag/mcap_files.hpp"

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

// On the writing thread, which the second message makes write the chunk of the first.
TEST(Recorder, WhatIsNoExceptionEndsTheRecordingAndNotTheProcess) {
  class Odd final : public ByteSink {
   public:
    void write(BytesView bytes) override {
      if (bytes.size() > 500'000) throw 7;
      size_ += bytes.size();
    }
    void sync() override {}
    std::uint64_t size() const override { return size_; }

   private:
    std::atomic<std::uint64_t> size_ = 0;
  };
  const mcap::Folder folder;
  RecorderOptions options{.queue_size = 2'500'000};
  options.writer.compression = Compression::none;
  options.writer.create = [](const std::filesystem::path&) { return std::make_unique<Odd>(); };
  Recorder recorder(folder / "a.mcap", options);
  const std::size_t a = recorder.add_topic(topic("/a"));
  const std::string megabyte(1'000'000, 'm');
  for (std::int64_t i = 0; i < 2; ++i) recorder.record(a, {i}, {i}, mcap::as_bytes(megabyte));
  recorder.close();
  EXPECT_EQ(recorder.status().error, "something that is no std::exception");
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

/// A disk that one can pull the plug of: what was not synced is forgotten.
class ForgetfulDisk final : public ByteSink {
 public:
  struct Platter {
    std::mutex mutex;
    std::condition_variable changed;
    Bytes kept;
    int syncs = 0;
    /// What is on it after so many syncs.
    Bytes after(int count) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return syncs >= count; });
      return kept;
    }
  };
  explicit ForgetfulDisk(std::shared_ptr<Platter> platter) : platter_(std::move(platter)) {}
  void write(BytesView bytes) override {
    const std::lock_guard lock(platter_->mutex);
    written_.insert(written_.end(), bytes.begin(), bytes.end());
  }
  void sync() override {
    const std::lock_guard lock(platter_->mutex);
    platter_->kept = written_;
    ++platter_->syncs;
    platter_->changed.notify_all();
  }
  std::uint64_t size() const override { return written_.size(); }

 private:
  std::shared_ptr<Platter> platter_;
  Bytes written_;
};

TEST(Recorder, SyncsByItselfSoThatAPowerCutLeavesABagThatOpens) {
  const mcap::Folder folder;
  auto platter = std::make_shared<ForgetfulDisk::Platter>();
  RecorderOptions options;
  options.writer.create = [platter](const std::filesystem::path&) {
    return std::make_unique<ForgetfulDisk>(platter);
  };
  Recorder recorder(folder / "a.mcap", options);
  const std::size_t a = recorder.add_topic(topic("/a"));
  for (std::int64_t i = 0; i < 100; ++i) recorder.record(a, {i}, {i}, mcap::as_bytes("before the cut"));
  // The recorder alone decides when: the second sync began after all of it was written.
  const Bytes kept = platter->after(2);
  const std::filesystem::path cut = folder / "cut.mcap";
  mcap::write_content(cut, {reinterpret_cast<const char*>(kept.data()), kept.size()});
  EXPECT_EQ(times(cut), up_to(100));
  EXPECT_EQ(open_bag(cut)->faults().size(), 1U);  // it was not closed
}

TEST(Recorder, WritesOnWhileTheDeviceTakesItsTimeToSync) {
  class LongSync final : public ByteSink {
   public:
    LongSync(std::unique_ptr<ByteSink> file, std::shared_ptr<StuckDisk::Gate> gate)
        : file_(std::move(file)), gate_(std::move(gate)) {}
    void write(BytesView bytes) override { file_->write(bytes); }
    void sync() override { gate_->pass(); }
    std::uint64_t size() const override { return file_->size(); }

   private:
    std::unique_ptr<ByteSink> file_;
    std::shared_ptr<StuckDisk::Gate> gate_;
  };
  const mcap::Folder folder;
  auto gate = std::make_shared<StuckDisk::Gate>();
  gate->set(false);
  RecorderOptions options;
  options.writer.create = [gate](const std::filesystem::path& file) {
    return std::make_unique<LongSync>(create_file(file), gate);
  };
  Recorder recorder(folder / "a.mcap", options);
  const std::size_t a = recorder.add_topic(topic("/a"));
  gate->wait_until_stuck();
  for (std::int64_t i = 0; i < 100; ++i) recorder.record(a, {i}, {i}, mcap::as_bytes("text"));
  while (recorder.status().flushed < 100) std::this_thread::yield();
  EXPECT_EQ(times(folder / "a.mcap"), up_to(100));  // while the sync has not returned
  gate->set(true);
  recorder.close();
}

TEST(Recorder, SaysWhenASyncFails) {
  class FailingSync final : public ByteSink {
   public:
    void write(BytesView bytes) override { size_ += bytes.size(); }
    void sync() override { throw std::system_error(EIO, std::generic_category(), "disk"); }
    std::uint64_t size() const override { return size_; }

   private:
    std::atomic<std::uint64_t> size_ = 0;
  };
  const mcap::Folder folder;
  RecorderOptions options;
  options.writer.create = [](const std::filesystem::path&) { return std::make_unique<FailingSync>(); };
  Recorder recorder(folder / "a.mcap", options);
  while (recorder.status().error.empty()) std::this_thread::yield();
  EXPECT_THAT(recorder.status().error, ::testing::HasSubstr("Input/output error"));
}

/// A disk that takes a number of bytes each time somebody turns it on, and waits for the next time.
class SlowDisk final : public ByteSink {
 public:
  struct Supply {
    std::mutex mutex;
    std::condition_variable changed;
    std::uint64_t bytes = 0;
    void give(std::uint64_t more) {
      const std::lock_guard lock(mutex);
      bytes += more;
      changed.notify_all();
    }
  };
  SlowDisk(std::unique_ptr<ByteSink> file, std::shared_ptr<Supply> supply)
      : file_(std::move(file)), supply_(std::move(supply)) {}
  void write(BytesView bytes) override {
    std::unique_lock lock(supply_->mutex);
    supply_->changed.wait(lock, [&] { return supply_->bytes >= bytes.size(); });
    supply_->bytes -= bytes.size();
    file_->write(bytes);
  }
  void sync() override { file_->sync(); }
  std::uint64_t size() const override { return file_->size(); }

 private:
  std::unique_ptr<ByteSink> file_;
  std::shared_ptr<Supply> supply_;
};

TEST(Recorder, ADiskOfAMegabyteASecondGetsWhatItCanTakeAndTheRestIsCounted) {
  const mcap::Folder folder;
  auto supply = std::make_shared<SlowDisk::Supply>();
  RecorderOptions options{.queue_size = 4'000'000};
  options.writer.compression = Compression::none;
  options.writer.create = [supply](const std::filesystem::path& file) {
    return std::make_unique<SlowDisk>(create_file(file), supply);
  };
  supply->give(10'000);  // for the head of the file
  Recorder recorder(folder / "a.mcap", options);
  const std::size_t a = recorder.add_topic(topic("/a"));
  const std::string message(100'000, 'm');
  // Twenty seconds in which 2 MB come and 1 MB is taken: record() returns each time, however far the disk is
  // behind.
  std::uint64_t sent = 0;
  for (int second = 0; second < 20; ++second) {
    for (int i = 0; i < 20; ++i, ++sent) {
      const auto time = static_cast<std::int64_t>(sent);
      recorder.record(a, {time}, {time}, mcap::as_bytes(message));
    }
    supply->give(1'000'000);
  }
  supply->give(100'000'000);
  recorder.close();
  const RecorderStatus status = recorder.status();
  EXPECT_TRUE(status.error.empty());
  const std::vector<std::int64_t> kept = times(folder / "a.mcap");
  EXPECT_EQ(kept.size(), status.recorded);
  // 40 MB came; queue, writing thread and disk took no more than 4 + 4 + 20 of them.
  ASSERT_TRUE(status.dropped.contains("/a"));
  EXPECT_EQ(kept.size() + status.dropped.at("/a"), sent);
  EXPECT_GE(status.dropped.at("/a"), 120U);
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
