// Bags that were cut and mutated: whatever they hold, they are read as far as they can be, or refused in
// words. Nothing crashes, nothing is allocated from a length that nobody checked, and no message is given out
// that was not written.
//
//   BANDWAGON_BAG_MUTATIONS=20000 build/asan/bin/test_bag_bad_input       the full count
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <set>

#include <gmock/gmock.h>
#include <unistd.h>

#include "runtime/recording/bag/bag_metadata.hpp"
#include "runtime/recording/bag/bag_report.hpp"
#include "runtime/recording/bag/mcap_recover.hpp"
#include "tests/runtime/file_mutator.hpp"
#include "tests/runtime/largest_allocation.hpp"
#include "tests/runtime/recording/bag/sample_bags.hpp"

namespace bw::bag {
namespace {

// The window in which recovery looks for chunks and the first step of decompression are 1 MiB. Files here
// have 20 kB.
constexpr std::size_t kMaxAtOnce = std::size_t{2} << 20;

/// What a program does with a bag that it was handed. False: it was refused, in words.
bool use(const std::filesystem::path& path, Reading& reading) {
  try {
    const auto bag = open_bag(path);
    reading = read_all(*bag);
    static_cast<void>(examine(*bag));
    static_cast<void>(bag->metadata());
    for (const BagAttachment& a : bag->attachments()) static_cast<void>(bag->attachment(a.name));
    return true;
  } catch (const std::runtime_error& error) {
    EXPECT_STRNE(error.what(), "");
    return false;
  }
}

void recover_into(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::filesystem::remove(to);
  try {
    static_cast<void>(mcap::recover(from, to));
  } catch (const std::runtime_error&) {
    return;  // no MCAP file at all
  }
  const auto bag = open_bag(to);
  EXPECT_TRUE(bag->faults().empty()) << "what was recovered is damaged";
}

struct Kind {
  const char* name;
  const char* file;
  bool has_checksums;  ///< of its messages
  std::function<void(const std::filesystem::path&)> write;
};

std::vector<Kind> kinds(const std::vector<Taken>& messages) {
  const auto mcap_file = [&messages](Compression compression) {
    return [&messages, compression](const std::filesystem::path& file) {
      write_sample_bag(file, messages, compression);
    };
  };
  return {{"zstd", "a.mcap", true, mcap_file(Compression::zstd)},
          {"lz4", "a.mcap", true, mcap_file(Compression::lz4)},
          {"uncompressed", "a.mcap", true, mcap_file(Compression::none)},
          {"without chunks", "a.mcap", false,
           [&](const auto& file) { mcap::write_content(file, loose_sample_bag(messages)); }},
          {"sqlite3", "a.db3", false, [&](const auto& file) { write_sample_sqlite(file, messages); }},
          {"metadata.yaml", "metadata.yaml", true, [&](const auto& file) {
             write_sample_bag(file.parent_path() / "a.mcap", messages, Compression::zstd);
             mcap::write_content(file, to_yaml({.topics = {{.name = "/a", .type = "a/msg/A"}},
                                                .files = {{.path = "a.mcap"}}}));
           }}};
}

TEST(Mutations, AreReadAsFarAsTheyCanBeOrRefused) {
  const char* asked = std::getenv("BANDWAGON_BAG_MUTATIONS");
  const int count = asked == nullptr ? 1000 : std::atoi(asked);
  const mcap::Folder folder;
  const auto messages = sample_messages(90);
  const std::set<Taken> written(messages.begin(), messages.end());
  const std::vector<Kind> all = kinds(messages);
  std::vector<std::string> whole;
  for (const Kind& kind : all) {
    std::filesystem::create_directories(folder / kind.name);
    kind.write(folder / kind.name / kind.file);
    whole.push_back(mcap::content_of(folder / kind.name / kind.file));
  }
  largest_allocation = 0;
  test::FileMutator mutate(12);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i) % all.size();
    const Kind& kind = all[k];
    const std::filesystem::path file = folder / kind.name / kind.file;
    mcap::write_content(file, mutate(whole[k]));
    Reading reading;
    if (!use(file.extension() == ".yaml" ? file.parent_path() : file, reading)) ++refused;
    if (kind.has_checksums) {
      for (const Taken& m : reading.messages)
        ASSERT_TRUE(written.contains(m))
            << "mutation " << i << " (" << kind.name << ") gives out what nobody wrote";
    }
    if (file.extension() == ".mcap") recover_into(file, folder / "recovered.mcap");
    ASSERT_LE(largest_allocation, kMaxAtOnce) << "mutation " << i << ", " << kind.name;
  }
  EXPECT_LT(refused, count / 2);
}

/// The file with all its checksums 0, "not available": every length is believed as far as it can be.
std::string without_checksums(std::string content) {
  const Bytes bytes(content.begin(), content.end());
  std::size_t offset = mcap::kMagic.size();
  mcap::RecordView record;
  while (mcap::next_record(BytesView(bytes).first(bytes.size() - mcap::kMagic.size()), offset, record)) {
    const std::size_t at = record.offset + mcap::kRecordPrefix;
    std::size_t checksum = at + record.content.size() - 4;  // of DataEnd, footer and attachment
    if (record.opcode == mcap::Opcode::chunk) checksum = at + 24;
    if (record.opcode == mcap::Opcode::chunk || record.opcode == mcap::Opcode::data_end ||
        record.opcode == mcap::Opcode::footer || record.opcode == mcap::Opcode::attachment)
      content.replace(checksum, 4, std::string(4, '\0'));
  }
  return content;
}

/// As small as a file can be that has everything.
void write_small_file(const std::filesystem::path& file, Compression compression) {
  mcap::Writer writer(create_file(file), {.compression = compression, .chunk_size = 1200});
  mcap::declare(writer);
  mcap::write_all(writer, mcap::rising(24));
  writer.write(
      mcap::Attachment{.log_time = 3, .create_time = 0, .name = "a", .media_type = "b", .data = {'x'}});
  writer.write(mcap::Metadata{.name = "m", .entries = {{"k", "v"}}});
  writer.close();
}

class EveryByte : public ::testing::TestWithParam<Compression> {};

TEST_P(EveryByte, MayBeTheBeginningOfAHugeLength) {
  const mcap::Folder folder;
  const std::filesystem::path file = folder / "a.mcap";
  write_small_file(file, GetParam());
  const std::string whole = without_checksums(mcap::content_of(file));
  Reading untouched;
  mcap::write_content(file, whole);
  ASSERT_TRUE(use(file, untouched));
  ASSERT_EQ(untouched.messages.size(), 24U);
  largest_allocation = 0;
  // 2 GB, and more than any file; the first is that of 8 bytes as well where the upper four are 0.
  for (const std::string& length :
       {std::string("\x00\x00\x00\x80", 4), std::string("\xff\xff\xff\xff\xff\xff\xff\x7f")}) {
    for (std::size_t at = mcap::kMagic.size(); at + length.size() <= whole.size(); ++at) {
      std::string content = whole;
      content.replace(at, length.size(), length);
      mcap::write_content(file, content);
      Reading reading;
      use(file, reading);
      ASSERT_LE(largest_allocation, kMaxAtOnce) << length.size() << " bytes at " << at;
    }
  }
}

TEST_P(EveryByte, MayBeWrongAndCostsOneChunkAtMost) {
  const mcap::Folder folder;
  const std::filesystem::path file = folder / "a.mcap";
  write_small_file(file, GetParam());
  const std::string whole = mcap::content_of(file);
  const std::vector<Taken> messages = read_all(*open_bag(file)).messages;
  std::vector<mcap::ChunkIndex> chunks;
  {
    const ByteSource source(file);
    chunks = mcap::read_contents(source).chunks;
  }
  ASSERT_GE(chunks.size(), 2U);
  int lost = 0;
  for (std::size_t at = mcap::kMagic.size(); at < whole.size(); ++at) {
    std::string content = whole;
    content[at] = static_cast<char>(content[at] ^ 0x55);
    mcap::write_content(file, content);
    Reading reading;
    ASSERT_TRUE(use(file, reading)) << "byte " << at;
    if (reading.messages == messages) continue;
    ++lost;
    const auto hit = std::ranges::find_if(chunks, [at](const mcap::ChunkIndex& c) {
      return at >= c.chunk_start && at < c.chunk_start + c.chunk_length;
    });
    ASSERT_NE(hit, chunks.end()) << "byte " << at << " is in no chunk, and messages are lost";
    std::vector<Taken> expected;
    std::ranges::copy_if(messages, std::back_inserter(expected), [&](const Taken& m) {
      const auto time = static_cast<std::uint64_t>(std::get<1>(m));
      return time < hit->start_time || time > hit->end_time;
    });
    ASSERT_TRUE(reading.messages == expected) << "byte " << at << " costs more than its chunk";
    ASSERT_EQ(reading.faults.size(), 1U) << "byte " << at;
    ASSERT_EQ(reading.faults[0].offset, hit->chunk_start) << "byte " << at;
  }
  EXPECT_GT(lost, 500);  // most bytes are those of messages
}

INSTANTIATE_TEST_SUITE_P(All, EveryByte,
                         ::testing::Values(Compression::none, Compression::lz4, Compression::zstd));

}  // namespace
}  // namespace bw::bag
