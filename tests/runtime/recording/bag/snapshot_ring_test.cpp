// What stays in memory and what goes: by age, by size, latched messages never. Expected numbers are those
// written.
#include "runtime/recording/bag/snapshot_ring.hpp"

#include <gmock/gmock.h>

#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::bag {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::size_t kBlock = 1040;  // [bytes]; a message of 72 and the 32 in front of it take a tenth
const std::string kText(72, 't');

std::int64_t add(SnapshotRing& ring, std::size_t topic, std::int64_t time, const std::string& text = kText) {
  EXPECT_TRUE(ring.add({topic, {time}, {time}, mcap::as_bytes(text)}));
  return time;
}

/// Times from the cursor on.
std::vector<std::int64_t> read(SnapshotRing& ring, SnapshotRing::Cursor& cursor, std::uint64_t& lost) {
  std::vector<std::int64_t> times;
  while (true) {
    SnapshotRing::Stretch stretch = ring.read(cursor, lost);
    const std::size_t before = times.size();
    for (KeptMessage m; stretch.next(m);) times.push_back(m.log_time.nanoseconds);
    if (times.size() == before) return times;
  }
}

std::vector<std::int64_t> all(SnapshotRing& ring) {
  SnapshotRing::Cursor cursor = ring.begin();
  std::uint64_t lost = 0;
  return read(ring, cursor, lost);
}

std::vector<std::int64_t> range(std::int64_t first, std::int64_t end) {
  std::vector<std::int64_t> times;
  for (std::int64_t i = first; i < end; ++i) times.push_back(i);
  return times;
}

TEST(SnapshotRing, GivesBackWhatCameInItsOrder) {
  SnapshotRing ring({.memory = 100 * kBlock, .block_size = kBlock});
  const std::size_t a = ring.add_topic(0);
  const std::size_t b = ring.add_topic(0);
  add(ring, a, 3, "first");
  add(ring, b, 5, "");
  add(ring, a, 4, "third, of an odd length");
  SnapshotRing::Cursor cursor = ring.begin();
  std::uint64_t lost = 0;
  SnapshotRing::Stretch stretch = ring.read(cursor, lost);
  std::vector<std::string> seen;
  for (KeptMessage m; stretch.next(m);) {
    seen.push_back(std::to_string(m.topic) + "@" + std::to_string(m.log_time.nanoseconds) + " " +
                   std::string(m.data.begin(), m.data.end()));
  }
  EXPECT_THAT(seen, ElementsAre("0@3 first", "1@5 ", "0@4 third, of an odd length"));
}

TEST(SnapshotRing, ACursorGoesOnWhereItWas) {
  SnapshotRing ring({.memory = 100 * kBlock, .block_size = kBlock});
  const std::size_t a = ring.add_topic(0);
  SnapshotRing::Cursor cursor;
  std::uint64_t lost = 0;
  std::int64_t now = 0;
  for (int round = 0; round < 50; ++round) {
    const std::int64_t before = now;
    for (int i = 0; i < round % 7; ++i) add(ring, a, now++);
    EXPECT_EQ(read(ring, cursor, lost), range(before, now));
  }
  EXPECT_EQ(lost, 0U);
}

TEST(SnapshotRing, TheOldGoesByBlocksOnceItWasRead) {
  SnapshotRing ring({.keep = Duration{25}, .memory = 100 * kBlock, .block_size = kBlock});
  const std::size_t a = ring.add_topic(0);
  for (std::int64_t i = 0; i < 60; ++i) add(ring, a, i);
  EXPECT_EQ(all(ring), range(0, 60));  // nobody has read it
  add(ring, a, 60);
  // Ten in a block: 0 to 29 are older than 60 - 25, 30 to 39 are not all.
  EXPECT_EQ(all(ring), range(30, 61));
}

TEST(SnapshotRing, TheOldestGoesBeforeTheMemoryIsFull) {
  SnapshotRing ring({.keep = Duration{1'000'000}, .memory = 8 * kBlock, .block_size = kBlock});
  const std::size_t a = ring.add_topic(0);
  SnapshotRing::Cursor cursor;
  std::uint64_t lost = 0;
  for (std::int64_t i = 0; i < 200; ++i) {
    add(ring, a, i);
    ASSERT_LE(ring.memory(), 8 * kBlock);
  }
  // Eight blocks of ten.
  EXPECT_EQ(read(ring, cursor, lost), range(120, 200));
  EXPECT_EQ(lost, 120U);
  EXPECT_EQ(ring.span(), Duration{79});
}

TEST(SnapshotRing, AMessageLargerThanABlockHasOneOfItsOwnAndOneLargerThanTheMemoryIsRefused) {
  SnapshotRing ring({.memory = 10 * kBlock, .block_size = kBlock});
  const std::size_t a = ring.add_topic(0);
  add(ring, a, 0);
  add(ring, a, 1, std::string(5 * kBlock, 'l'));
  add(ring, a, 2);
  EXPECT_EQ(all(ring), range(0, 3));
  EXPECT_FALSE(ring.add({a, {3}, {3}, mcap::as_bytes(std::string(10 * kBlock, 'x'))}));
  EXPECT_EQ(all(ring), range(0, 3));
}

TEST(SnapshotRing, TheLatestLatchedMessagesStay) {
  SnapshotRing ring({.memory = 8 * kBlock, .block_size = kBlock});
  const std::size_t map = ring.add_topic(1);
  const std::size_t tf_static = ring.add_topic(2);
  const std::size_t scan = ring.add_topic(0);
  for (std::int64_t i = 0; i < 3; ++i) add(ring, map, i, "map " + std::to_string(i));
  for (std::int64_t i = 3; i < 6; ++i) add(ring, tf_static, i, "tf " + std::to_string(i));
  for (std::int64_t i = 6; i < 200; ++i) add(ring, scan, i);
  std::vector<std::string> kept;
  for (const auto& [topic, messages] : ring.latched()) {
    for (const auto& m : messages) kept.emplace_back(m.data.begin(), m.data.end());
  }
  EXPECT_THAT(kept, ElementsAre("map 2", "tf 4", "tf 5"));
  EXPECT_LE(ring.memory(), 8 * kBlock);
}

}  // namespace
}  // namespace bw::bag
