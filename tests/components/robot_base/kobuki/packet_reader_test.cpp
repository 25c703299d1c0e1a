// Packets out of good and bad streams.
#include "components/robot_base/kobuki/packet_reader.hpp"

#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

#include "components/robot_base/kobuki/feedback.hpp"
#include "tests/components/robot_base/kobuki/packets.hpp"

namespace bw::kobuki {
namespace {

/// Stamps of the core data of all packets.
std::vector<int> stamps(PacketReader& reader) {
  std::vector<int> all;
  for (auto payload = reader.next(); !payload.empty(); payload = reader.next())
    all.push_back(parse(payload).core.value_or(Core{.stamp = 9999}).stamp);
  return all;
}

TEST(KobukiPacketReader, TakesAPacketInAnyPieces) {
  const Bytes bytes = whole_packet({.stamp = 7});
  // 17 + 5 + 9 + 8 + 4 + 16 + 18 = 77 of payload, 4 around it.
  ASSERT_EQ(bytes.size(), 81U);
  PacketReader reader;
  std::vector<int> found;
  for (int packet = 0; packet < 3; ++packet) {
    for (const std::uint8_t byte : bytes) {
      reader.add({&byte, 1});
      for (const int stamp : stamps(reader)) found.push_back(stamp);
    }
  }
  EXPECT_EQ(found, (std::vector<int>{7, 7, 7}));
  EXPECT_EQ(reader.counts().bytes_thrown_away, 0U);
}

TEST(KobukiPacketReader, AWrongChecksumCostsThatPacketAlone) {
  Bytes broken = whole_packet({.stamp = 1});
  broken[40] ^= 0x10;
  PacketReader reader;
  reader.add(joined({broken, whole_packet({.stamp = 2})}));
  EXPECT_EQ(stamps(reader), std::vector<int>{2});
  EXPECT_EQ(reader.counts().bad_checksums, 1U);
  EXPECT_EQ(reader.counts().bytes_thrown_away, 81U);
}

// A beginning that announces 255 bytes, and sub-payloads that fill them, would hold three packets back.
TEST(KobukiPacketReader, AFalseBeginningHoldsNothingBack) {
  PacketReader reader;
  reader.add(Bytes{0xAA, 0x55, 0xFF, 0x77, 0xFD});
  reader.add(whole_packet({.stamp = 1}));
  EXPECT_EQ(stamps(reader), std::vector<int>{1});
  EXPECT_EQ(reader.counts().bytes_thrown_away, 5U);
}

TEST(KobukiPacketReader, HalfAPacketDoesNotSpoilTheNext) {
  Bytes half = whole_packet({.stamp = 1});
  for (std::size_t cut = 1; cut < half.size(); ++cut) {
    PacketReader reader;
    reader.add(std::span<const std::uint8_t>(half).first(cut));
    reader.add(whole_packet({.stamp = 2}));
    EXPECT_EQ(stamps(reader), std::vector<int>{2}) << cut;
  }
}

TEST(KobukiPacketReader, RefusesWhatSubPayloadsDoNotFill) {
  PacketReader reader;
  reader.add(packet({0x77, 5, 1, 2, 3}));     // announces 5, has 3
  reader.add(packet({0x77, 1, 1, 0x78}));     // an id alone is left over
  reader.add(Bytes{0xAA, 0x55, 0x00, 0x00});  // nothing in it
  EXPECT_TRUE(stamps(reader).empty());
  reader.add(joined({packet({0x77, 3, 1, 2, 3}), whole_packet({.stamp = 3})}));
  EXPECT_EQ(stamps(reader), (std::vector<int>{9999, 3}));  // unknown, and skipped by its size
}

// AA 55 within the data of a sound packet begins none.
TEST(KobukiPacketReader, DataThatLooksLikeABeginningIsData) {
  const Bytes bytes = packet(
      joined({core_payload({.stamp = 0x55AA, .left = 0x55AA, .right = 0x04}), {0x77, 4, 0xAA, 0x55, 2, 0}}));
  PacketReader reader;
  for (int packet = 0; packet < 2; ++packet) {
    reader.add(std::span(bytes).first(20));
    EXPECT_TRUE(stamps(reader).empty());
    reader.add(std::span(bytes).subspan(20));
    EXPECT_EQ(stamps(reader), std::vector<int>{0x55AA});
  }
  EXPECT_EQ(reader.counts().bytes_thrown_away, 0U);
}

}  // namespace
}  // namespace bw::kobuki
