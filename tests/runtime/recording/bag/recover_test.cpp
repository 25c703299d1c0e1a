// What `bag recover` saves: everything but the damaged chunk, also behind it.
#include <gmock/gmock.h>
#include <unistd.h>

#include "runtime/recording/bag/mcap_recover.hpp"
#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::bag::mcap {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

struct Original {
  std::vector<Sample> samples = rising(300);
  std::string content;
  std::vector<ChunkIndex> chunks;

  explicit Original(const Folder& folder) {
    {
      Writer writer(create_file(folder / "original.mcap"), {.chunk_size = 4096});
      declare(writer);
      write_all(writer, samples);
      writer.write(Metadata{.name = "m", .entries = {{"a", "b"}}});
      writer.close();
    }
    content = content_of(folder / "original.mcap");
    const ByteSource file(folder / "original.mcap");
    chunks = read_contents(file).chunks;
  }
  std::vector<Sample> without(const ChunkIndex& chunk) const {
    std::vector<Sample> rest;
    for (const Sample& s : samples) {
      if (s.log_time < chunk.start_time || s.log_time > chunk.end_time) rest.push_back(s);
    }
    return rest;
  }
};

TEST(McapRecover, AWholeFileStaysWhole) {
  const Folder folder;
  const Original original(folder);
  const RecoveryReport report = recover(folder / "original.mcap", folder / "b.mcap");
  EXPECT_TRUE(report.was_whole);
  EXPECT_EQ(report.messages, 300U);
  EXPECT_EQ(read_back(folder / "b.mcap").samples, original.samples);
}

TEST(McapRecover, ACutFileGetsAnEnd) {
  const Folder folder;
  const Original original(folder);
  const ChunkIndex& last = original.chunks.back();
  write_content(folder / "a.mcap",
                original.content.substr(0, static_cast<std::size_t>(last.chunk_start) + 30));
  const RecoveryReport report = recover(folder / "a.mcap", folder / "b.mcap");
  EXPECT_FALSE(report.was_whole);
  EXPECT_EQ(report.lost_bytes, 30U);
  EXPECT_EQ(read_back(folder / "b.mcap").samples, original.without(last));
  const ByteSource file(folder / "b.mcap");
  EXPECT_TRUE(read_contents(file).from_summary);
}

TEST(McapRecover, GoesOnBehindADamagedChunk) {
  const Folder folder;
  const Original original(folder);
  const ChunkIndex& chunk = original.chunks.at(1);
  std::string content = original.content;
  // A length that leads nowhere: who believes it loses all that follows.
  content.replace(static_cast<std::size_t>(chunk.chunk_start) + 1, 8, std::string(8, '\x7f'));
  write_content(folder / "a.mcap", content);
  const RecoveryReport report = recover(folder / "a.mcap", folder / "b.mcap");
  ASSERT_THAT(report.faults, SizeIs(1));
  EXPECT_EQ(report.faults[0].offset, chunk.chunk_start);
  EXPECT_THAT(report.faults[0].what, HasSubstr("more than the file holds"));
  // The chunk and the indexes behind it.
  EXPECT_EQ(report.lost_bytes, original.chunks.at(2).chunk_start - chunk.chunk_start);
  EXPECT_EQ(read_back(folder / "b.mcap").samples, original.without(chunk));
}

TEST(McapRecover, DoesNotPassOnWhatItsChecksumDenies) {
  const Folder folder;
  const Original original(folder);
  const ChunkIndex& chunk = original.chunks.at(0);
  std::string content = original.content;
  content[static_cast<std::size_t>(chunk.chunk_start + chunk.chunk_length) - 20] ^= 4;
  write_content(folder / "a.mcap", content);
  EXPECT_FALSE(recover(folder / "a.mcap", folder / "b.mcap").was_whole);
  EXPECT_EQ(read_back(folder / "b.mcap").samples, original.without(chunk));
}

TEST(McapRecover, NeverWritesOverAFile) {
  const Folder folder;
  const Original original(folder);
  EXPECT_THROW(recover(folder / "original.mcap", folder / "original.mcap"), std::system_error);
}

}  // namespace
}  // namespace bw::bag::mcap
