// Files and folders that are no bags, or not ours: each is refused in words that name the place, or read as
// far as it is sound. Expected offsets are those at which the test did the damage.
#include <functional>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime/recording/bag/bag_report.hpp"
#include "runtime/recording/bag/bag_writer.hpp"
#include "tests/runtime/largest_allocation.hpp"
#include "tests/runtime/recording/bag/sample_bags.hpp"

namespace bw::bag {
namespace {

using mcap::said_by;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

std::string said_on_opening(const std::filesystem::path& path) {
  return said_by([&] { static_cast<void>(open_bag(path)); });
}

TEST(BadInput, WhatIsNoBagIsRefusedByName) {
  const mcap::Folder folder;
  mcap::write_content(folder / "text.mcap", "#ROSBAG V2.0\n and more");
  EXPECT_THAT(said_on_opening(folder / "text.mcap"),
              AllOf(HasSubstr("text.mcap is no MCAP file"), HasSubstr("byte 0")));
  mcap::write_content(folder / "empty.mcap", "");
  EXPECT_THAT(said_on_opening(folder / "empty.mcap"), HasSubstr("empty.mcap is no MCAP file: it is empty"));
  EXPECT_THAT(said_on_opening(folder / "missing.mcap"), HasSubstr("missing.mcap: No such file"));
  EXPECT_THAT(said_on_opening("/dev/null"), HasSubstr("/dev/null: it is no regular file"));
  ASSERT_EQ(mkfifo((folder / "pipe.mcap").c_str(), 0600), 0);
  EXPECT_THAT(said_on_opening(folder / "pipe.mcap"), HasSubstr("it is no regular file"));
}

TEST(BadInput, AFolderIsABagOnlyIfItHoldsOne) {
  const mcap::Folder folder;
  std::filesystem::create_directories(folder / "drive.mcap");
  EXPECT_THAT(said_on_opening(folder / "drive.mcap"),
              HasSubstr("holds neither metadata.yaml nor .mcap nor .db3"));
  EXPECT_THAT(said_on_opening(folder / ""), HasSubstr("drive.mcap: it is a folder"));
  std::filesystem::create_directories(folder / "named");
  mcap::write_content(folder / "named/metadata.yaml", to_yaml({.files = {{.path = "gone_0.mcap"}}}));
  EXPECT_THAT(said_on_opening(folder / "named"), HasSubstr("gone_0.mcap: No such file"));
}

TEST(BadInput, AFileOfNothingButItsBeginningIsEmptyAndSaysWhy) {
  const mcap::Folder folder;
  Bytes start(mcap::kMagic.begin(), mcap::kMagic.end());
  append(start, mcap::Header{"ros2", "another"});
  for (const std::size_t length : {mcap::kMagic.size(), start.size()}) {
    mcap::write_content(folder / "a.mcap", std::string(start.begin(), start.end()).substr(0, length));
    const auto bag = open_bag(folder / "a.mcap");
    EXPECT_EQ(bag->message_count(), 0U);
    EXPECT_THAT(read_all(*bag).messages, IsEmpty());
    ASSERT_FALSE(bag->faults().empty());
    EXPECT_EQ(bag->faults()[0].offset, length);
    EXPECT_THAT(bag->faults()[0].what, HasSubstr("was not closed"));
  }
}

TEST(BadInput, ABagWithoutMessagesIsSound) {
  const mcap::Folder folder;
  write_sample_bag(folder / "a.mcap", {}, Compression::zstd);
  const auto bag = open_bag(folder / "a.mcap");
  EXPECT_THAT(bag->topics(), SizeIs(3));
  EXPECT_TRUE(examine(*bag).is_sound());
}

TEST(BadInput, OtherProfilesPassThroughUndecoded) {
  const mcap::Folder folder;
  for (const std::string profile : {"", "ros1", "x-something"}) {
    const std::filesystem::path file = folder / ("a" + profile + ".mcap");
    {
      mcap::Writer writer(create_file(file), {.profile = profile});
      writer.add_schema({.id = 1, .name = "std_msgs/String", .encoding = "ros1msg", .data = {'s'}});
      writer.add_channel(
          {.id = 1, .schema_id = 1, .topic = "/a", .message_encoding = "ros1", .metadata = {}});
      mcap::write_all(writer, {{1, 5, 5, "\x01 not CDR"}});
      writer.close();
    }
    const auto bag = open_bag(file);
    EXPECT_EQ(bag->profile(), profile);
    EXPECT_THAT(read_all(*bag).messages, ElementsAre(Taken("/a", 5, "\x01 not CDR")));
    EXPECT_EQ(bag->topics()[0].serialization_format, "ros1");
    EXPECT_TRUE(examine(*bag).is_sound());  // nobody here can say what such bytes should be
  }
}

TEST(BadInput, OtherEncodingsOfATypeWeKnowAreNotDecoded) {
  const mcap::Folder folder;
  {
    BagWriter writer(folder / "a.mcap", {});
    for (const char* encoding : {"protobuf", "json"}) {
      const std::size_t topic = writer.add_topic({.name = std::string("/") + encoding,
                                                  .type = "std_msgs/msg/String",
                                                  .serialization_format = encoding,
                                                  .schema_encoding = encoding,
                                                  .schema_text = "whatever they write"});
      writer.write(topic, {1}, {1}, mcap::as_bytes("{}"));
    }
    writer.close();
  }
  const BagReport report = examine(*open_bag(folder / "a.mcap"));
  EXPECT_TRUE(report.is_sound());
  EXPECT_THAT(report.topics[0].difference, HasSubstr("encoded as protobuf, not cdr"));
  EXPECT_THAT(report.topics[1].difference, HasSubstr("encoded as json, not cdr"));
}

TEST(BadInput, AnUnknownCompressionIsNamedWithItsChunk) {
  const mcap::Folder folder;
  const auto messages = sample_messages(30);
  write_sample_bag(folder / "a.mcap", messages, Compression::zstd);
  std::string content = mcap::content_of(folder / "a.mcap");
  mcap::ChunkIndex chunk;
  {
    const ByteSource file(folder / "a.mcap");
    chunk = mcap::read_contents(file).chunks.at(1);
  }
  // In the chunk; the summary still says zstd.
  const std::size_t name = content.find("zstd", static_cast<std::size_t>(chunk.chunk_start));
  content.replace(name, 4, "brot");
  mcap::write_content(folder / "b.mcap", content);
  const Reading reading = read_all(*open_bag(folder / "b.mcap"));
  ASSERT_THAT(reading.faults, SizeIs(1));
  EXPECT_EQ(reading.faults[0].offset, chunk.chunk_start);
  EXPECT_THAT(reading.faults[0].what, HasSubstr("compression \"brot\" is unknown; known: none, lz4, zstd"));
  std::vector<Taken> others;
  for (const Taken& m : messages) {
    const auto time = static_cast<std::uint64_t>(std::get<1>(m));
    if (time < chunk.start_time || time > chunk.end_time) others.push_back(m);
  }
  EXPECT_TRUE(reading.messages == others);
}

/// A bag with one message of `data` that says it is a sensor_msgs/msg/LaserScan.
void write_scan(const std::filesystem::path& file, const std::string& schema, const std::string& hash,
                const std::string& data) {
  BagWriter writer(file, {});
  const std::size_t topic = writer.add_topic({.name = "/scan",
                                              .type = "sensor_msgs/msg/LaserScan",
                                              .type_hash = hash,
                                              .schema_encoding = "ros2msg",
                                              .schema_text = schema});
  writer.write(topic, {1}, {1}, mcap::as_bytes(data));
  writer.close();
}

TEST(BadInput, ATypeOfOurNameWithOtherFieldsIsNotTakenForOurs) {
  const mcap::Folder folder;
  const TypeDescription& scan = *find_type("sensor_msgs/msg/LaserScan");
  const auto bytes = test::RandomPayload(3, 4)(scan);
  const std::string data(bytes.begin(), bytes.end());
  std::string schema = schema_text(scan);
  schema.replace(schema.find("float32 range_min"), 17, "float64 range_min");
  write_scan(folder / "fields.mcap", schema, "", data);
  BagReport report = examine(*open_bag(folder / "fields.mcap"));
  EXPECT_EQ(report.topics[0].malformed, 0U);
  EXPECT_EQ(report.topics[0].difference,
            "the bag's schema has float64 range_min where this build has float32 range_min");

  const std::string hash = "RIHS01_" + std::string(64, '0');
  write_scan(folder / "hash.mcap", schema_text(scan), hash, data);
  report = examine(*open_bag(folder / "hash.mcap"));
  EXPECT_EQ(report.topics[0].difference,
            "its type hash " + hash + " is not this build's " + std::string(scan.type_hash));
}

TEST(BadInput, AMessageThatIsNotOfItsTypeIsCounted) {
  const mcap::Folder folder;
  const TypeDescription& scan = *find_type("sensor_msgs/msg/LaserScan");
  const auto bytes = test::RandomPayload(3, 4)(scan);
  const std::string data(bytes.begin(), bytes.end() - 3);
  write_scan(folder / "a.mcap", schema_text(scan), std::string(scan.type_hash), data);
  const BagReport report = examine(*open_bag(folder / "a.mcap"));
  EXPECT_FALSE(report.is_sound());
  EXPECT_EQ(report.topics[0].malformed, 1U);
  EXPECT_THAT(report.topics[0].first_malformed, HasSubstr("intensities"));  // the last field
}

TEST(BadInput, FallingStampsAreReadInOrderAndCounted) {
  const mcap::Folder folder;
  {
    BagWriter writer(folder / "a.mcap", {});
    const std::size_t topic = writer.add_topic({.name = "/a", .type = "std_msgs/msg/Nothing"});
    // Log times fall once, in the order of writing; stamps fall once, in the order of log times.
    for (const auto& [log, stamp] :
         {std::pair(10, 10), std::pair(30, 30), std::pair(20, 20), std::pair(40, 25)})
      writer.write(topic, {log}, {stamp}, mcap::as_bytes("x"));
    writer.close();
  }
  const auto bag = open_bag(folder / "a.mcap");
  std::vector<std::int64_t> times;
  for (const auto& [topic, time, data] : read_all(*bag).messages) times.push_back(time);
  EXPECT_THAT(times, ElementsAre(10, 20, 30, 40));
  const BagReport report = examine(*bag);
  EXPECT_EQ(report.topics[0].falling, 1U);
  EXPECT_EQ(report.topics[0].first_falling.nanoseconds, 40);
  EXPECT_FALSE(report.is_sound());
}

TEST(BadInput, TimesBeyondAllMeasureAreBorne) {
  const mcap::Folder folder;
  {
    mcap::Writer writer(create_file(folder / "a.mcap"), {});
    mcap::declare(writer);
    for (const std::uint64_t time : {~std::uint64_t{0}, std::uint64_t{0}, std::uint64_t{1} << 63U})
      mcap::write_all(writer, {{1, time, ~time, "x"}});
    writer.close();
  }
  const auto bag = open_bag(folder / "a.mcap");
  EXPECT_THAT(read_all(*bag).messages, SizeIs(3));
  EXPECT_THAT(examine(*bag).clock_jumps, SizeIs(1));
}

TEST(BadInput, ARecordOfGigabytesIsNotReadEvenWhereTheFileIsAsLong) {
  const mcap::Folder folder;
  const auto messages = sample_messages(9);
  const std::filesystem::path file = folder / "a.mcap";
  write_sample_bag(file, messages, Compression::none, 1);  // a chunk for each message
  std::uint64_t last = 0;
  {
    const ByteSource source(file);
    last = mcap::read_contents(source).chunks.back().chunk_start;
  }
  std::string content = mcap::content_of(file).substr(0, static_cast<std::size_t>(last) + 1);
  content += std::string("\x00\x00\x00\x80\x00\x00\x00\x00", 8);  // 2 GiB
  mcap::write_content(file, content);
  ASSERT_EQ(truncate(file.c_str(), std::int64_t{6} << 30), 0);  // sparse: the disk does not notice
  largest_allocation = 0;
  const Reading reading = read_all(*open_bag(file));
  EXPECT_LE(largest_allocation, std::size_t{1} << 20);
  EXPECT_TRUE(reading.messages == std::vector<Taken>(messages.begin(), messages.end() - 1));
  ASSERT_THAT(reading.faults, SizeIs(2));
  EXPECT_EQ(reading.faults[1].offset, last);
  EXPECT_THAT(reading.faults[1].what, HasSubstr("claims 2147483648 bytes, more than any record may have"));
}

TEST(BadInput, AFooterThatNamesGigabytesOfSummaryIsNotBelieved) {
  const mcap::Folder folder;
  const std::filesystem::path file = folder / "a.mcap";
  write_sample_bag(file, sample_messages(9), Compression::none);
  std::string content = mcap::content_of(file);
  // The summary shall begin behind the magic; 4 GiB of nothing lie between it and the footer.
  const std::string footer_and_magic = content.substr(content.size() - 37);
  content.resize(content.size() - 37);
  const auto whole = static_cast<std::int64_t>(content.size());
  mcap::write_content(file, content);
  ASSERT_EQ(truncate(file.c_str(), whole + (std::int64_t{4} << 30)), 0);
  {
    Bytes end;
    append(end, mcap::Footer{.summary_start = 8});
    std::ofstream out(file, std::ios::binary | std::ios::app);
    out.write(reinterpret_cast<const char*>(end.data()), static_cast<std::streamsize>(end.size()));
    out.write(reinterpret_cast<const char*>(mcap::kMagic.data()), mcap::kMagic.size());
  }
  largest_allocation = 0;
  const auto bag = open_bag(file);
  EXPECT_LE(largest_allocation, std::size_t{1} << 20);
  EXPECT_THAT(bag->faults().at(0).what, HasSubstr("the footer names a summary of"));
  EXPECT_EQ(bag->message_count(), 9U);
}

TEST(BadInput, AChunkIsReadOnceHoweverOftenTheSummaryNamesIt) {
  const mcap::Folder folder;
  const std::filesystem::path file = folder / "a.mcap";
  write_sample_bag(file, sample_messages(9), Compression::none);
  const std::string content = mcap::content_of(file);
  Bytes summary;
  std::uint64_t start = 0;
  {
    const ByteSource source(file);
    const mcap::Contents contents = mcap::read_contents(source);
    for (const auto& [id, schema] : contents.schemas) append(summary, schema);
    for (const auto& [id, channel] : contents.channels) append(summary, channel);
    for (int i = 0; i < 1000; ++i) append(summary, contents.chunks.at(0));
    Bytes footer;
    ASSERT_TRUE(source.read(source.size() - 37 + 9, 20, footer));
    mcap::Footer parsed;
    ASSERT_TRUE(mcap::parse(footer, parsed));
    start = parsed.summary_start;
  }
  append(summary, mcap::Footer{.summary_start = start});
  mcap::write_content(file, content.substr(0, static_cast<std::size_t>(start)) +
                                std::string(summary.begin(), summary.end()) +
                                std::string(mcap::kMagic.begin(), mcap::kMagic.end()));
  const Reading reading = read_all(*open_bag(file));
  EXPECT_THAT(reading.messages, SizeIs(9));
  ASSERT_THAT(reading.faults, SizeIs(1));
  EXPECT_THAT(reading.faults[0].what, HasSubstr("chunks that lie in each other"));
}

TEST(BadInput, ADatabaseThatIsCutGivesWhatItStillHas) {
  const mcap::Folder folder;
  const auto messages = sample_messages(900);
  write_sample_sqlite(folder / "a.db3", messages);
  const std::string whole = mcap::content_of(folder / "a.db3");
  mcap::write_content(folder / "b.db3", whole.substr(0, whole.size() / 2));
  const Reading reading = read_all(*open_bag(folder / "b.db3"));
  ASSERT_THAT(reading.faults, SizeIs(2));  // on counting and on reading
  EXPECT_THAT(reading.faults[1].what, HasSubstr("malformed"));
  ASSERT_THAT(reading.messages, Not(IsEmpty()));
  EXPECT_TRUE(std::equal(reading.messages.begin(), reading.messages.end(), messages.begin()));
}

}  // namespace
}  // namespace bw::bag
