// A saved graph: the same again, and gone on with as if there had been no break.
#include "components/slam/graph_file.hpp"

#include <array>
#include <bit>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/slam/relocalization.hpp"
#include "tests/components/slam/building_slam.hpp"
#include "tests/components/slam/graph_samples.hpp"

namespace bw::slam {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(GraphFile, GivesBackTheSameBytes) {
  const std::string bytes = test::small_graph();
  const GraphReading reading = read_graph(bytes);
  ASSERT_TRUE(reading.graph) << reading.fault;
  EXPECT_EQ(reading.graph->X_MW, test::kStart);
  EXPECT_GE(reading.graph->slam.closing.submaps.size(), 4U);
  EXPECT_GT(reading.graph->slam.nodes.size(), 40U);
  EXPECT_EQ(graph_bytes(*reading.graph), bytes);
  Slam slam(reading.graph->slam);
  EXPECT_EQ(graph_bytes({test::kStart, slam.save()}), bytes);
}

// Scans wait while the state is taken: of what does not change any more nothing is copied.
TEST(GraphFile, SharesTheWallsOfFinishedSubmaps) {
  Slam slam(read_graph(test::small_graph()).graph->slam);
  const SlamState state = slam.save();
  ASSERT_EQ(state.closing.submaps.size(), slam.map().size());
  for (std::size_t k = 0; k < slam.map().size(); ++k) {
    EXPECT_FALSE(slam.map()[k].surfaces.empty());
    EXPECT_EQ(state.closing.submaps[k].surfaces.data(), slam.map()[k].surfaces.data()) << "submap " << k;
  }
}

// A map without any scan is a graph too.
TEST(GraphFile, MayBeEmpty) {
  Slam slam{SlamOptions{}};
  const std::string bytes = graph_bytes({{}, slam.save()});
  const GraphReading reading = read_graph(bytes);
  ASSERT_TRUE(reading.graph) << reading.fault;
  EXPECT_EQ(graph_bytes(*reading.graph), bytes);
}

std::array<std::uint64_t, 3> bits(const Pose2& X) {
  return {std::bit_cast<std::uint64_t>(X.x), std::bit_cast<std::uint64_t>(X.y),
          std::bit_cast<std::uint64_t>(X.theta)};
}

// Half of a drive through an office, saved, read, and the other half: bit by bit the drive without a break,
// loops and the map at the end included.
TEST(GraphFile, GoesOnAsIfThereHadBeenNoBreak) {
  const test::BuildingDrive drive =
      test::drive_in(buildings::make_building(buildings::BuildingKind::office, 2), 4, 160.0);
  const std::size_t half = drive.scans.size() / 2;
  const std::size_t all = drive.scans.size();
  Slam whole{SlamOptions{}};
  test::map_along(whole, drive, 0, half);
  whole.settle();  // as saving does
  const std::vector<Pose2> expected = test::map_along(whole, drive, half, all);
  ASSERT_GT(whole.loop_counts().accepted, 0);

  std::string saved;
  {
    Slam first{SlamOptions{}};
    test::map_along(first, drive, 0, half);
    saved = graph_bytes({{}, first.save()});
  }
  GraphReading reading = read_graph(saved);
  ASSERT_TRUE(reading.graph) << reading.fault;
  Slam second(std::move(reading.graph->slam));
  const std::vector<Pose2> told = test::map_along(second, drive, half, all);
  for (std::size_t k = 0; k < told.size(); ++k)
    ASSERT_EQ(bits(told[k]), bits(expected[k])) << "scan " << half + k;
  EXPECT_EQ(second.loop_counts().accepted, whole.loop_counts().accepted);
  EXPECT_TRUE(graph_bytes({{}, second.save()}) == graph_bytes({{}, whole.save()}));
  RecordProperty("bytes", static_cast<int>(saved.size()));
}

// Two drives through one office: the second begins elsewhere, with odometry of its own, and is told where.
// Both are one map then, with loops between them. Truth: where it drove.
TEST(GraphFile, ASecondDriveGoesIntoTheSameMap) {
  const buildings::Building building = buildings::make_building(buildings::BuildingKind::office, 2);
  const test::BuildingDrive one = test::drive_in(building, 4, 100.0);
  const test::BuildingDrive two = test::drive_in(building, 5, 100.0);
  Slam first{SlamOptions{}};
  test::map_along(first, one, 0, one.scans.size());
  Slam slam(std::move(read_graph(graph_bytes({{}, first.save()})).graph->slam));
  slam.finish();
  const std::size_t submaps = slam.submaps();
  const std::size_t start = 150;
  const Pose2 X_MW = inverse(one.X_WB[0]);
  const auto place = place_near(slam, two.scans[start].points, X_MW * two.X_WB[start], {0.5, 0.5, 0.3});
  ASSERT_TRUE(place);
  slam.begin_at(place->submap, place->X_SB);
  const std::vector<Pose2> told = test::map_along(slam, two, start, two.scans.size());
  EXPECT_GT(slam.submaps(), submaps + 5);
  EXPECT_GT(std::ranges::count_if(
                slam.edges(), [&](const Edge& e) { return e.loop && e.from < submaps && e.to >= submaps; }),
            2);
  double worst = 0.0;
  for (std::size_t k = 0; k < told.size(); ++k)
    worst = std::max(worst, (told[k].position() - (X_MW * two.X_WB[start + k]).position()).norm());
  EXPECT_LT(worst, 0.25);
  const std::string bytes = graph_bytes({{}, slam.save()});
  const GraphReading reading = read_graph(bytes);
  ASSERT_TRUE(reading.graph) << reading.fault;
  EXPECT_EQ(graph_bytes(*reading.graph), bytes);
}

std::string fault_with(std::size_t at, std::string_view content) {
  std::string bytes = test::small_graph();
  bytes.replace(at, content.size(), content);
  return read_graph(test::sealed(bytes)).fault;
}

// Offsets as graph_file.md has them. HEAD begins at byte 20, its content at 32.
TEST(GraphFile, SaysWhichByteAndWhichRule) {
  using namespace std::string_literals;
  EXPECT_THAT(read_graph("").fault, HasSubstr("must be those of a pose graph"));
  EXPECT_THAT(read_graph("P5\n2 1\n255\n\xfe").fault, HasSubstr("must be those of a pose graph"));
  EXPECT_THAT(fault_with(8, "\x04\0\0\0"s),
              AllOf(HasSubstr("byte 8"), HasSubstr("version: 4"), HasSubstr("reads version 3")));
  EXPECT_THAT(fault_with(8, "\0\0\0\0"s), AllOf(HasSubstr("version: 0"), HasSubstr("reads version 3")));
  EXPECT_THAT(fault_with(32, "\0\0\0\0\0\0\xf8\x7f"s),
              AllOf(HasSubstr("byte 32 (HEAD): resolution: "), HasSubstr("nan")));
  EXPECT_THAT(fault_with(32, "\0\0\0\0\0\0\xf0\x3f"s),
              AllOf(HasSubstr("resolution: 1:"), HasSubstr("within 0.01 and 0.2")));
  EXPECT_THAT(fault_with(64, "\2"s), HasSubstr("byte 64 (HEAD): do_loop_closing: 2: must be 0 or 1"));
  EXPECT_THAT(fault_with(145, "\xff\xff\xff\x0f"s), AllOf(HasSubstr("(SUBM)"), HasSubstr("has no room")));
  // The content of NODE begins with how many there are; the first one's number is 0, the second's 1.
  const std::size_t nodes = test::small_graph().find("NODE") + 12;
  EXPECT_THAT(fault_with(nodes + 4, "\5\0\0\0"s),
              HasSubstr("(NODE): number of a node: 1: must be above that of the one before"));
  EXPECT_THAT(fault_with(nodes + 4, "\0\0\0\1"s), HasSubstr("number of a node: 16777216: must be below"));
  std::string bytes = test::small_graph();
  bytes[40] = static_cast<char>(bytes[40] ^ 1);
  EXPECT_THAT(read_graph(bytes).fault, AllOf(HasSubstr("(HEAD): checksum"), HasSubstr("they were changed")));
  bytes = test::small_graph() + "more";
  EXPECT_THAT(read_graph(bytes).fault, AllOf(HasSubstr("byte 12: size"), HasSubstr("the file has ")));
}

}  // namespace
}  // namespace bw::slam
