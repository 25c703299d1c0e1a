// Recordings: folders, splits, limits, locks, disks that fail. Expected counts and times are those written.
#include "runtime/recording/bag/bag_writer.hpp"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/recording/bag/qos_text.hpp"
#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::bag {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

const BagTopic kTopic{.name = "/text",
                      .type = "std_msgs/msg/String",
                      .offered_qos_profiles = "- depth: 1",
                      .type_hash = "RIHS01_00",
                      .schema_encoding = "ros2msg",
                      .schema_text = "string data\n"};

std::vector<std::int64_t> times(const Bag& bag) {
  std::vector<std::int64_t> out;
  const auto messages = bag.messages({});
  for (BagMessage m; messages->next(m) == Step::message;) out.push_back(m.log_time.nanoseconds);
  return out;
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename());
  return names;
}

TEST(BagWriter, WritesAFolderThatRosbag2Reads) {
  const mcap::Folder folder;
  {
    BagWriter writer(folder / "drive", {.ros_distro = "humble"});
    const std::size_t topic = writer.add_topic(kTopic);
    writer.attach("graph.yaml", "text/yaml", "components:", {5});
    for (std::int64_t i = 1; i <= 3; ++i) writer.write(topic, {i}, {10 * i}, mcap::as_bytes("abc"));
    writer.close();
  }
  EXPECT_THAT(names_in(folder / "drive"), UnorderedElementsAre("drive_0.mcap", "metadata.yaml"));
  const BagMetadata metadata = read_bag_metadata(folder / "drive/metadata.yaml");
  EXPECT_EQ(metadata.version, 8);
  EXPECT_EQ(metadata.ros_distro, "humble");
  EXPECT_EQ(metadata.message_count, 3U);
  EXPECT_EQ(metadata.start, 1U);
  EXPECT_EQ(metadata.duration, 2U);
  EXPECT_EQ(metadata.topics.at(0).message_count, 3U);
  const auto bag = open_bag(folder / "drive");
  EXPECT_THAT(times(*bag), ElementsAre(1, 2, 3));
  ASSERT_THAT(bag->topics(), SizeIs(1));
  EXPECT_EQ(bag->topics()[0].schema_text, kTopic.schema_text);
  EXPECT_EQ(bag->topics()[0].type_hash, kTopic.type_hash);
  const Bytes graph = bag->attachment("graph.yaml").value();
  EXPECT_EQ(std::string(graph.begin(), graph.end()), "components:");
  EXPECT_THAT(bag->metadata().at("rosbag2").at("serialized_metadata"), HasSubstr("version: 8"));
  EXPECT_EQ(ros_distro_in(bag->metadata()), "humble");
}

// As rosbag2 takes it from the environment; without one the layouts are Jazzy's.
TEST(BagWriter, NamesTheDistributionOfTheEnvironment) {
  const char* before = std::getenv("ROS_DISTRO");
  const std::string kept = before == nullptr ? "" : before;
  setenv("ROS_DISTRO", "kilted", 1);
  EXPECT_EQ(BagWriterOptions{}.ros_distro, "kilted");
  unsetenv("ROS_DISTRO");
  EXPECT_EQ(BagWriterOptions{}.ros_distro, "jazzy");
  if (before != nullptr) setenv("ROS_DISTRO", kept.c_str(), 1);
}

// A recording tells who was where and when.
TEST(BagWriter, WritesForItsOwnerAlone) {
  const mcap::Folder folder;
  const auto mode = [&](const char* name) { return std::filesystem::status(folder / name).permissions(); };
  const mode_t before = umask(0);
  BagWriter(folder / "new/drive", {}).close();
  BagWriter(folder / "single/drive.mcap", {}).close();
  umask(before);
  for (const char* made : {"new", "new/drive", "single"})
    EXPECT_EQ(mode(made), std::filesystem::perms(0700)) << made;
  for (const char* made : {"new/drive/drive_0.mcap", "single/drive.mcap"})
    EXPECT_EQ(mode(made), std::filesystem::perms(0600)) << made;
}

TEST(BagWriter, WritesASingleFileByItsName) {
  const mcap::Folder folder;
  {
    BagWriter writer(folder / "drive.mcap", {});
    writer.write(writer.add_topic(kTopic), {7}, {7}, mcap::as_bytes("x"));
    writer.close();
  }
  EXPECT_THAT(times(*open_bag(folder / "drive.mcap")), ElementsAre(7));
}

TEST(BagWriter, SplitsByTimeAndSize) {
  const mcap::Folder folder;
  const std::string filler(1000, 'f');
  for (const auto& [name, options] :
       {std::pair("time", BagWriterOptions{.split_duration = Duration{2}}),
        std::pair("size", BagWriterOptions{.compression = Compression::none, .split_size = 3000})}) {
    BagWriter writer(folder / name, options);
    const std::size_t topic = writer.add_topic(kTopic);
    for (std::int64_t i = 0; i < 6; ++i) writer.write(topic, {i}, {i}, mcap::as_bytes(filler));
    writer.close();
    // Times 0 to 2 span 2 ns; three messages of 1031 bytes exceed 3000.
    EXPECT_THAT(
        names_in(folder / name),
        UnorderedElementsAre(std::string(name) + "_0.mcap", std::string(name) + "_1.mcap", "metadata.yaml"));
    EXPECT_THAT(times(*open_bag(folder / name)), ElementsAre(0, 1, 2, 3, 4, 5));
  }
}

TEST(BagWriter, AKilledRecordingOfSeveralFilesIsReadWhole) {
  const mcap::Folder folder;
  const std::string filler(1000, 'f');
  {
    BagWriter writer(folder / "d", {.compression = Compression::none, .split_size = 3000});
    const std::size_t topic = writer.add_topic(kTopic);
    for (std::int64_t i = 0; i < 8; ++i) writer.write(topic, {i}, {i}, mcap::as_bytes(filler));
    writer.flush();
  }  // without close()
  const auto bag = open_bag(folder / "d");
  // Three messages of 1031 bytes exceed 3000: two files are closed, the third has two messages.
  EXPECT_THAT(names_in(folder / "d"), UnorderedElementsAre("d_0.mcap", "d_1.mcap", "d_2.mcap"));
  EXPECT_THAT(times(*bag), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(bag->faults(), SizeIs(1));  // of the file that was not closed
}

/// Counts what was asked of the device.
class CountingDisk final : public ByteSink {
 public:
  CountingDisk(std::unique_ptr<ByteSink> file, std::vector<std::uint64_t>& synced)
      : file_(std::move(file)), synced_(synced) {}
  void write(BytesView bytes) override { file_->write(bytes); }
  void sync() override { synced_.push_back(size()); }
  std::uint64_t size() const override { return file_->size(); }

 private:
  std::unique_ptr<ByteSink> file_;
  std::vector<std::uint64_t>& synced_;
};

TEST(BagWriter, EveryFileIsSyncedWhole) {
  const mcap::Folder folder;
  std::vector<std::uint64_t> synced;
  BagWriter writer(folder / "d", {.split_duration = Duration{2}, .create = [&](const auto& file) {
                                    return std::make_unique<CountingDisk>(create_file(file), synced);
                                  }});
  const std::size_t topic = writer.add_topic(kTopic);
  for (std::int64_t i = 0; i < 6; ++i) writer.write(topic, {i}, {i}, mcap::as_bytes("text"));
  writer.close();
  EXPECT_THAT(synced, ElementsAre(std::filesystem::file_size(folder / "d/d_0.mcap"),
                                  std::filesystem::file_size(folder / "d/d_1.mcap")));
}

TEST(BagWriter, StaysBelowItsLimitAndKeepsWhatABagCannotBeWithout) {
  const mcap::Folder folder;
  const std::string filler(1000, 'f');
  BagWriter writer(folder / "d", {.compression = Compression::none, .max_size = 200'000});
  BagTopic latched = kTopic;
  latched.name = "/map";
  latched.offered_qos_profiles = to_qos_text({Qos::latched()});
  const std::size_t map = writer.add_topic(latched);
  const std::size_t text = writer.add_topic(kTopic);
  writer.attach("graph.yaml", "text/yaml", "components:", {});
  writer.add_metadata("bandwagon", {{"seed", "7"}});
  for (const char* content : {"old map", "new map"}) writer.write(map, {0}, {0}, mcap::as_bytes(content));
  for (std::int64_t i = 1; i <= 2000; ++i) {
    writer.write(text, {i}, {i}, mcap::as_bytes(filler));
    ASSERT_LE(writer.size(), 200'000U);
  }
  writer.close();
  const auto bag = open_bag(folder / "d");
  EXPECT_TRUE(bag->faults().empty());
  EXPECT_EQ(bag->attachments().size(), 1U);
  EXPECT_EQ(bag->attachment("graph.yaml")->size(), 11U);
  EXPECT_EQ(bag->metadata().at("bandwagon").at("seed"), "7");
  std::vector<std::string> maps;
  std::uint64_t count = 0;
  const auto messages = bag->messages({});
  for (BagMessage m; messages->next(m) == Step::message; ++count) {
    if (bag->topics()[m.topic].name == "/map") maps.emplace_back(m.data.begin(), m.data.end());
  }
  EXPECT_THAT(maps, ElementsAre("new map"));
  const BagMetadata metadata = read_bag_metadata(folder / "d/metadata.yaml");
  EXPECT_EQ(metadata.message_count, count);
  EXPECT_EQ(metadata.start, static_cast<std::uint64_t>(bag->start().nanoseconds));
  EXPECT_EQ(metadata.start + metadata.duration, 2000U);
  EXPECT_GT(count, 150U);  // of 193 messages of 1031 bytes at most; a tenth goes at a time
}

TEST(BagWriter, DropsTheOldestFilesBeyondTheLimit) {
  const mcap::Folder folder;
  const std::string filler(1000, 'f');
  BagWriter writer(folder / "d", {.compression = Compression::none, .split_size = 3000, .max_size = 12'000});
  const std::size_t topic = writer.add_topic(kTopic);
  for (std::int64_t i = 0; i < 60; ++i) writer.write(topic, {i}, {i}, mcap::as_bytes(filler));
  writer.close();
  const auto bag = open_bag(folder / "d");
  const std::vector<std::int64_t> kept = times(*bag);
  EXPECT_EQ(kept.back(), 59);
  EXPECT_EQ(kept.front(), 60 - static_cast<std::int64_t>(kept.size()));  // the newest, without a gap
  EXPECT_GE(kept.size(), 4U);
  EXPECT_LE(kept.size(), 12U);  // 12 messages alone have more than 12,000 bytes
  const BagMetadata metadata = read_bag_metadata(folder / "d/metadata.yaml");
  EXPECT_EQ(metadata.message_count, kept.size());
  EXPECT_EQ(metadata.topics.at(0).message_count, kept.size());
}

TEST(BagWriter, RefusesAFolderThatIsUsedOrWritten) {
  const mcap::Folder folder;
  {
    BagWriter first(folder / "d", {});
    try {
      const BagWriter second(folder / "d", {});
      FAIL() << "two recorders in one folder";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("another recorder writes there"));
    }
    first.close();
  }
  try {
    const BagWriter again(folder / "d", {});
    FAIL() << "a recording is overwritten";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("is not empty"));
  }
}

/// A disk with room for so many bytes.
class SmallDisk final : public ByteSink {
 public:
  SmallDisk(std::unique_ptr<ByteSink> file, std::uint64_t room) : file_(std::move(file)), room_(room) {}
  void write(BytesView bytes) override {
    const std::uint64_t fits = std::min<std::uint64_t>(bytes.size(), room_ - file_->size());
    file_->write(bytes.first(static_cast<std::size_t>(fits)));
    if (fits < bytes.size()) throw std::system_error(ENOSPC, std::generic_category(), "disk");
  }
  void sync() override { file_->sync(); }
  std::uint64_t size() const override { return file_->size(); }

 private:
  std::unique_ptr<ByteSink> file_;
  std::uint64_t room_;
};

TEST(BagWriter, WhatFitOnAFullDiskIsRead) {
  const mcap::Folder folder;
  const std::string filler(1000, 'f');
  BagWriter writer(folder / "d",
                   {.compression = Compression::none, .create = [](const std::filesystem::path& file) {
                      return std::make_unique<SmallDisk>(create_file(file), 10'000);
                    }});
  const std::size_t topic = writer.add_topic(kTopic);
  std::int64_t written = 0;
  try {
    for (; written < 100; ++written) {
      writer.write(topic, {written}, {written}, mcap::as_bytes(filler));
      writer.flush();
    }
    FAIL() << "the disk was never full";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ENOSPC);
  }
  const auto bag = open_bag(folder / "d");
  EXPECT_THAT(times(*bag), SizeIs(static_cast<std::size_t>(written)));
  EXPECT_FALSE(bag->faults().empty());
}

}  // namespace
}  // namespace bw::bag
