// Golden bytes of rmw_dds_common/msg/ParticipantEntitiesInfo, laid out by hand from its definition (CDR1,
// little endian).
#include "runtime/ros/discovery_info.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

dds::Guid guid(std::uint8_t first) {
  dds::Guid g;
  std::iota(g.begin(), g.end(), first);
  return g;
}

ParticipantEntities example() {
  return {.participant = guid(1),
          .nodes = {
              {.node_namespace = "/", .name = "n1", .readers = {guid(32)}, .writers = {guid(64), guid(96)}}}};
}

void append(std::vector<std::uint8_t>& bytes, std::initializer_list<int> more) {
  for (const int b : more) bytes.push_back(static_cast<std::uint8_t>(b));
}

void append_gid(std::vector<std::uint8_t>& bytes, const dds::Guid& g, std::size_t size) {
  bytes.insert(bytes.end(), g.begin(), g.end());
  bytes.resize(bytes.size() + size - g.size());
}

std::vector<std::uint8_t> golden(std::size_t gid_size) {
  std::vector<std::uint8_t> bytes = {0, 1, 0, 0};
  append_gid(bytes, guid(1), gid_size);
  append(bytes, {1, 0, 0, 0});                        // one node
  append(bytes, {2, 0, 0, 0, '/', 0, /*pad*/ 0, 0});  // namespace
  append(bytes, {3, 0, 0, 0, 'n', '1', 0, /*pad*/ 0});
  append(bytes, {1, 0, 0, 0});
  append_gid(bytes, guid(32), gid_size);
  append(bytes, {2, 0, 0, 0});
  append_gid(bytes, guid(64), gid_size);
  append_gid(bytes, guid(96), gid_size);
  return bytes;
}

TEST(DiscoveryInfo, BytesOfBothFormats) {
  EXPECT_EQ(encode(example(), GidFormat::iron_and_later), golden(16));
  EXPECT_EQ(encode(example(), GidFormat::humble), golden(24));
}

TEST(DiscoveryInfo, DecodesBothFormatsWithoutBeingTold) {
  for (const std::size_t gid_size : {16U, 24U}) {
    const auto decoded = decode_participant_entities(golden(gid_size));
    ASSERT_TRUE(decoded) << gid_size;
    EXPECT_EQ(decoded->participant, guid(1));
    ASSERT_EQ(decoded->nodes.size(), 1U);
    EXPECT_EQ(decoded->nodes[0].name, "n1");
    EXPECT_EQ(decoded->nodes[0].writers, (std::vector{guid(64), guid(96)}));
  }
}

TEST(DiscoveryInfo, MutatedBytesNeverHarm) {
  constexpr std::uint64_t kSeed = 11;
  RecordProperty("seed", static_cast<int>(kSeed));
  Random random(kSeed);
  int accepted = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::vector<std::uint8_t> bytes = golden(i % 2 == 0 ? 16 : 24);
    for (int edits = 1 + static_cast<int>(random.bits() % 4); edits > 0; --edits) {
      bytes[random.bits() % bytes.size()] = static_cast<std::uint8_t>(random.bits());
    }
    bytes.resize(bytes.size() - random.bits() % 8);
    const auto decoded = decode_participant_entities(bytes);
    if (!decoded) continue;
    ++accepted;
    std::size_t gids = 0;
    for (const auto& node : decoded->nodes) gids += node.readers.size() + node.writers.size();
    EXPECT_LE(gids * 16, bytes.size()) << "holds no more than was sent";
  }
  EXPECT_GT(accepted, 0);
}

}  // namespace
}  // namespace bw
