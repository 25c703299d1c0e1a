// A bag written again, and what a look at every byte finds. Expected messages are those of the bag it was
// made from.
#include "runtime/recording/bag/convert.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include "runtime/recording/bag/bag_report.hpp"
#include "runtime/recording/bag/bag_writer.hpp"
#include "tests/runtime/recording/bag/sample_bags.hpp"

namespace bw::bag {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string compression_in(const std::filesystem::path& file) {
  const ByteSource source(file);
  return mcap::read_contents(source).chunks.at(0).compression;
}

TEST(Convert, ToEveryCompressionKeepsEverything) {
  const mcap::Folder folder;
  const auto messages = sample_messages(90);
  write_sample_bag(folder / "a.mcap", messages, Compression::zstd);
  for (const Compression compression : {Compression::none, Compression::lz4, Compression::zstd}) {
    const std::string name(name_of(compression));
    const std::filesystem::path out = folder / ("b" + name + ".mcap");
    const ConvertReport report = convert(*open_bag(folder / "a.mcap"), out, compression);
    EXPECT_EQ(report.messages, 90U);
    EXPECT_EQ(report.size, std::filesystem::file_size(out));
    EXPECT_THAT(report.lost, IsEmpty());
    EXPECT_EQ(compression_in(out), name);
    const auto bag = open_bag(out);
    EXPECT_TRUE(read_all(*bag).messages == messages);
    EXPECT_TRUE(examine(*bag).is_sound());
    EXPECT_EQ(bag->attachment("graph.yaml"), (Bytes{'x', 'y'}));
    EXPECT_EQ(bag->metadata().at("bandwagon").at("version"), "1");
  }
}

TEST(Convert, GivesASqliteBagTheSchemasItLacks) {
  const mcap::Folder folder;
  const auto messages = sample_messages(30);
  write_sample_sqlite(folder / "a.db3", messages);
  EXPECT_EQ(convert(*open_bag(folder / "a.db3"), folder / "b.mcap", Compression::zstd).messages, 30U);
  const auto bag = open_bag(folder / "b.mcap");
  EXPECT_TRUE(read_all(*bag).messages == messages);
  for (const BagTopic& topic : bag->topics()) {
    EXPECT_EQ(topic.schema_encoding, "ros2msg");
    EXPECT_EQ(topic.schema_text, schema_text(*find_type(topic.type)));
  }
}

TEST(Convert, PassesOnWhatItDoesNotUnderstand) {
  const mcap::Folder folder;
  {
    mcap::Writer writer(create_file(folder / "a.mcap"), {.profile = "ros1"});
    writer.add_schema({.id = 3, .name = "std_msgs/String", .encoding = "ros1msg", .data = {'s'}});
    writer.add_channel({.id = 9, .schema_id = 3, .topic = "/a", .message_encoding = "ros1", .metadata = {}});
    writer.add_channel({.id = 4, .schema_id = 0, .topic = "/b", .message_encoding = "json", .metadata = {}});
    mcap::write_all(writer, {{9, 5, 5, "one"}, {4, 6, 6, "{}"}});
    writer.close();
  }
  convert(*open_bag(folder / "a.mcap"), folder / "b.mcap", Compression::none);
  const auto from = open_bag(folder / "a.mcap");
  const auto to = open_bag(folder / "b.mcap");
  EXPECT_EQ(to->profile(), "ros1");
  EXPECT_TRUE(read_all(*to).messages == read_all(*from).messages);
  ASSERT_THAT(to->topics(), SizeIs(2));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(to->topics()[i].schema_encoding, from->topics()[i].schema_encoding);
    EXPECT_EQ(to->topics()[i].serialization_format, from->topics()[i].serialization_format);
  }
  // No schema stays none: an empty one would be another claim.
  const ByteSource source(folder / "b.mcap");
  EXPECT_THAT(mcap::read_contents(source).schemas, SizeIs(1));
}

TEST(Convert, GoesOnBehindDamageAndSaysWhatIsLost) {
  const mcap::Folder folder;
  const auto messages = sample_messages(90);
  write_sample_bag(folder / "a.mcap", messages, Compression::none);
  std::string content = mcap::content_of(folder / "a.mcap");
  mcap::Contents contents;
  {
    const ByteSource file(folder / "a.mcap");
    contents = mcap::read_contents(file);
  }
  const mcap::ChunkIndex& chunk = contents.chunks.at(1);
  content[static_cast<std::size_t>(chunk.chunk_start + chunk.chunk_length) - 10] ^= 1;
  content[static_cast<std::size_t>(contents.attachments.at(0).offset) + 30] ^= 1;
  mcap::write_content(folder / "b.mcap", content);
  const ConvertReport report = convert(*open_bag(folder / "b.mcap"), folder / "c.mcap", Compression::zstd);
  ASSERT_THAT(report.lost, SizeIs(2));
  EXPECT_EQ(report.lost[0].offset, contents.attachments[0].offset);
  EXPECT_THAT(report.lost[0].what, HasSubstr("the attachment graph.yaml is damaged"));
  EXPECT_EQ(report.lost[1].offset, chunk.chunk_start);
  std::vector<Taken> rest;
  for (const Taken& m : messages) {
    const auto time = static_cast<std::uint64_t>(std::get<1>(m));
    if (time < chunk.start_time || time > chunk.end_time) rest.push_back(m);
  }
  EXPECT_EQ(report.messages, rest.size());
  const auto bag = open_bag(folder / "c.mcap");
  EXPECT_TRUE(read_all(*bag).messages == rest);
  EXPECT_TRUE(examine(*bag).is_sound());
}

/// What `examine` finds when one byte of a sound bag is another.
std::vector<BagFault> faults_with(const mcap::Folder& folder, std::uint64_t changed) {
  std::string content = mcap::content_of(folder / "a.mcap");
  content[static_cast<std::size_t>(changed)] ^= 1;
  mcap::write_content(folder / "b.mcap", content);
  return examine(*open_bag(folder / "b.mcap")).faults;
}

TEST(Verify, FindsWhatReadingDoesNotSee) {
  const mcap::Folder folder;
  write_sample_bag(folder / "a.mcap", sample_messages(90), Compression::zstd);
  mcap::Contents contents;
  {
    const ByteSource file(folder / "a.mcap");
    contents = mcap::read_contents(file);
  }
  // A message index, which others go by.
  std::vector<BagFault> faults =
      faults_with(folder, contents.chunks.at(0).message_index_offsets.at(0).second + 20);
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_THAT(faults[0].what, HasSubstr("checksum of the data section"));
  EXPECT_EQ(faults[0].offset, contents.summary_start - 13);  // of the record DataEnd

  faults = faults_with(folder, contents.attachments.at(0).offset + 30);
  ASSERT_THAT(faults, SizeIs(2));  // the attachment's own checksum, and that of all
  EXPECT_EQ(faults[0].offset, contents.attachments[0].offset);
}

TEST(Verify, FindsMessagesThatAreOnlyPromised) {
  const mcap::Folder folder;
  {
    mcap::Writer writer(create_file(folder / "a.mcap"), {});
    mcap::declare(writer);
    mcap::write_all(writer, mcap::rising(30));
    writer.close();
  }
  // A summary that counts one more, with a checksum that fits.
  std::string content = mcap::content_of(folder / "a.mcap");
  Bytes said;
  Bytes changed;
  mcap::Contents contents;
  {
    const ByteSource file(folder / "a.mcap");
    contents = mcap::read_contents(file);
  }
  append(said, contents.statistics);
  ++contents.statistics.message_count;
  append(changed, contents.statistics);
  const std::size_t at = content.find(std::string(said.begin(), said.end()));
  ASSERT_NE(at, std::string::npos);
  content.replace(at, changed.size(), std::string(changed.begin(), changed.end()));
  content.replace(content.size() - 12, 4, std::string(4, '\0'));  // the summary's checksum: not available
  mcap::write_content(folder / "b.mcap", content);
  const std::vector<BagFault> faults = examine(*open_bag(folder / "b.mcap")).faults;
  ASSERT_THAT(faults, SizeIs(1));
  EXPECT_EQ(faults[0].what, "31 messages are promised and 30 are there");
}

}  // namespace
}  // namespace bw::bag
