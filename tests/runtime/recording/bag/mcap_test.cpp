// MCAP files: what is written is read back, in order, whole or cut. Expected values are what was written, and
// the tables of the MCAP specification.
#include <algorithm>

#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::bag::mcap {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Writes a file of small chunks and closes it.
void write_file(const std::filesystem::path& path, const std::vector<Sample>& samples,
                Compression compression) {
  Writer writer(create_file(path), {.compression = compression, .chunk_size = 4096});
  declare(writer);
  write_all(writer, samples);
  writer.write(Attachment{
      .log_time = 3, .create_time = 0, .name = "graph.yaml", .media_type = "text/yaml", .data = {'x'}});
  writer.write(Metadata{.name = "bandwagon", .entries = {{"version", "1"}}});
  writer.close();
}

class McapCompression : public ::testing::TestWithParam<Compression> {};

TEST_P(McapCompression, GivesBackWhatWasWritten) {
  const Folder folder;
  const auto samples = rising(500);
  write_file(folder / "a.mcap", samples, GetParam());
  const ReadBack back = read_back(folder / "a.mcap");
  EXPECT_EQ(back.samples, samples);
  EXPECT_THAT(back.faults, IsEmpty());

  const ByteSource file(folder / "a.mcap");
  const Contents contents = read_contents(file);
  EXPECT_TRUE(contents.from_summary);
  EXPECT_THAT(contents.faults, IsEmpty());
  EXPECT_EQ(contents.header.profile, "ros2");
  EXPECT_EQ(contents.statistics.message_count, 500U);
  EXPECT_EQ(contents.statistics.channel_message_counts.at(7),
            166U);  // 500 messages in turn over three channels
  EXPECT_EQ(contents.statistics.end_time, 499'000'000U);
  EXPECT_EQ(contents.channels.at(1).metadata.at("k"), "v");
  EXPECT_GT(contents.chunks.size(), 5U);  // 500 x about 75 bytes in chunks of 4096
  ASSERT_THAT(contents.attachments, SizeIs(1));
  EXPECT_EQ(contents.attachments[0].name, "graph.yaml");
  ASSERT_THAT(contents.metadata, SizeIs(1));
}

INSTANTIATE_TEST_SUITE_P(All, McapCompression,
                         ::testing::Values(Compression::none, Compression::lz4, Compression::zstd));

TEST(Mcap, ReadsByTimeAndKeepsTheOrderOfWritingWithinOne) {
  const Folder folder;
  const std::vector<Sample> samples = {
      {1, 50, 0, "late"}, {1, 20, 0, "first"}, {2, 20, 0, "second"}, {1, 20, 0, "third"}};
  {
    Writer writer(create_file(folder / "a.mcap"), {.chunk_size = 1});  // a chunk for each message
    declare(writer);
    write_all(writer, samples);
    writer.close();
  }
  const ReadBack back = read_back(folder / "a.mcap");
  EXPECT_EQ(back.samples, (std::vector<Sample>{samples[1], samples[2], samples[3], samples[0]}));
}

TEST(Mcap, SelectsTimesAndChannels) {
  const Folder folder;
  write_file(folder / "a.mcap", rising(300), Compression::zstd);
  std::vector<Sample> expected;
  for (const Sample& s : rising(300)) {
    if (s.channel == 2 && s.log_time >= 100'000'000 && s.log_time < 200'000'000) expected.push_back(s);
  }
  const ReadBack back = read_back(
      folder / "a.mcap", {.start = 100'000'000, .end = 200'000'000, .channels = std::set<std::uint16_t>{2}});
  EXPECT_EQ(back.samples, expected);
  EXPECT_THAT(back.samples, SizeIs(34));  // 100, 103, ... 199 ms
}

TEST(Mcap, ChunksCloseByTime) {
  const Folder folder;
  {
    Writer writer(create_file(folder / "a.mcap"), {.chunk_duration = 1'000'000'000});
    declare(writer);
    for (std::uint64_t i = 0; i <= 30; ++i) write_all(writer, {{1, i * 100'000'000, 0, "x"}});
    writer.close();
  }
  const ByteSource file(folder / "a.mcap");
  std::vector<std::uint64_t> starts;
  for (const ChunkIndex& chunk : read_contents(file).chunks) starts.push_back(chunk.start_time);
  EXPECT_THAT(starts, ElementsAre(0U, 1'100'000'000U, 2'200'000'000U));  // 11 messages span exactly 1 s
}

TEST(Mcap, OverlappingChunksStayInOrderWithLittleMemory) {
  // 200 chunks of 1 MiB, each from the beginning to the end of time: more than is ever kept open.
  const Folder folder;
  constexpr int kChunks = 100;
  const std::string filler(500'000, 'f');
  {
    Writer writer(create_file(folder / "a.mcap"), {.chunk_duration = ~std::uint64_t{0}});
    declare(writer);
    for (std::uint64_t i = 0; i < kChunks; ++i)
      write_all(writer, {{1, i, 0, filler}, {1, 1'000'000 - i, 0, filler}});
    writer.close();
  }
  const ByteSource file(folder / "a.mcap");
  const Contents contents = read_contents(file);
  Messages messages(file, contents, {});
  Message message;
  std::uint64_t last = 0;
  int count = 0;
  while (messages.next(message) == Step::message) {
    EXPECT_GE(message.log_time, last);
    last = message.log_time;
    ++count;
  }
  EXPECT_EQ(count, 2 * kChunks);
}

TEST(Mcap, EveryCutOpensUpToItsLastWholeChunk) {
  const Folder folder;
  const auto samples = rising(24);
  {
    Writer writer(create_file(folder / "whole.mcap"), {.compression = Compression::none, .chunk_size = 512});
    declare(writer);
    write_all(writer, samples);
    writer.close();
  }
  const std::string whole = content_of(folder / "whole.mcap");
  const ByteSource file(folder / "whole.mcap");
  const std::vector<ChunkIndex> chunks = read_contents(file).chunks;
  for (std::size_t length = kMagic.size(); length < whole.size(); ++length) {
    write_content(folder / "cut.mcap", std::string_view(whole).substr(0, length));
    const ReadBack back = read_back(folder / "cut.mcap");
    ASSERT_LE(back.samples.size(), samples.size());
    ASSERT_TRUE(std::equal(back.samples.begin(), back.samples.end(), samples.begin())) << "cut at " << length;
    std::uint64_t expected = 0;
    for (const ChunkIndex& chunk : chunks) {
      if (chunk.chunk_start + chunk.chunk_length <= length) expected = chunk.end_time / 1'000'000 + 1;
    }
    ASSERT_EQ(back.samples.size(), expected) << "cut at " << length;
  }
}

TEST(Mcap, AFileThatWasNotClosedSaysSo) {
  const Folder folder;
  {
    Writer writer(create_file(folder / "a.mcap"), {});
    declare(writer);
    write_all(writer, rising(10));
    writer.flush();
  }
  const ByteSource file(folder / "a.mcap");
  const Contents contents = read_contents(file);
  EXPECT_FALSE(contents.from_summary);
  ASSERT_THAT(contents.faults, SizeIs(1));
  EXPECT_EQ(contents.faults[0].offset, file.size());
  EXPECT_THAT(contents.faults[0].what, HasSubstr("not closed"));
  EXPECT_EQ(contents.statistics.message_count, 10U);
}

TEST(Mcap, ADamagedChunkIsNamedAndTheRestIsRead) {
  const Folder folder;
  const auto samples = rising(200);
  write_file(folder / "a.mcap", samples, Compression::none);
  std::string content = content_of(folder / "a.mcap");
  std::uint64_t damaged_at = 0;
  std::uint64_t first_lost = 0;
  std::uint64_t last_lost = 0;
  {
    const ByteSource file(folder / "a.mcap");
    const ChunkIndex chunk = read_contents(file).chunks.at(1);
    damaged_at = chunk.chunk_start;
    first_lost = chunk.start_time;
    last_lost = chunk.end_time;
    content[static_cast<std::size_t>(chunk.chunk_start + chunk.chunk_length - 10)] ^= 1;
  }
  write_content(folder / "b.mcap", content);
  const ReadBack back = read_back(folder / "b.mcap");
  ASSERT_THAT(back.faults, SizeIs(1));
  EXPECT_EQ(back.faults[0].offset, damaged_at);
  EXPECT_THAT(back.faults[0].what, HasSubstr("checksum"));
  std::vector<Sample> expected;
  std::ranges::copy_if(samples, std::back_inserter(expected),
                       [&](const Sample& s) { return s.log_time < first_lost || s.log_time > last_lost; });
  EXPECT_EQ(back.samples, expected);
}

TEST(Mcap, RefusesWhatIsNoMcapFile) {
  const Folder folder;
  write_content(folder / "a.mcap", "#ROSBAG V2.0\n");
  EXPECT_THROW(read_back(folder / "a.mcap"), std::runtime_error);
  write_content(folder / "b.mcap", "");
  EXPECT_THROW(read_back(folder / "b.mcap"), std::runtime_error);
  EXPECT_THROW(read_back(folder / "missing.mcap"), std::runtime_error);
  EXPECT_THROW(read_back(folder / ""), std::runtime_error);  // a folder
}

}  // namespace
}  // namespace bw::bag::mcap
