// Graph files that were cut and changed: each is refused in words, or is a graph that SLAM goes on with. Nothing
// crashes, and nothing is allocated from a length that nobody checked.
//
//   BANDWAGON_GRAPH_MUTATIONS=1000000 build/asan/bin/test_slam_graph_bad_input       the full count
#include <cstdio>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "tests/components/slam/graph_samples.hpp"
#include "tests/runtime/file_mutator.hpp"
#include "tests/runtime/largest_allocation.hpp"

namespace bw::slam {
namespace {

/// A graph that was read goes on: two scans, one of them far away, and it can be saved again.
void go_on(SavedGraph graph) {
  const std::string bytes = graph_bytes(graph);
  const SlamOptions options = graph.slam.options;
  Slam slam(std::move(graph.slam));
  test::Scanner scanner(test::square_of_corridors(), 0.01, 9, {.beams = 60});
  const Scan scan = scanner.scan(Time::seconds(1000.0), {1.0, -4.0, 0.0}, options);
  for (const Pose2& X_OB : {Pose2{6.0, 0.0, 0.1}, Pose2{8.0, 3.0, 1.0}}) {
    slam.add(scan, X_OB);
    while (slam.advance()) {
    }
  }
  static_cast<void>(graph_bytes({{}, slam.save()}));
}

TEST(GraphMutation, ACutFileIsRefusedInWords) {
  const std::string& whole = test::small_graph();
  for (std::size_t size = 0; size < whole.size(); size += 97) {
    // With the size of what is left in its header, too: then the sections tell.
    for (const std::string& cut : {whole.substr(0, size), test::sealed(whole.substr(0, size))}) {
      const GraphReading reading = read_graph(cut);
      ASSERT_FALSE(reading.graph) << size;
      ASSERT_NE(reading.fault.find("byte "), std::string::npos) << reading.fault;
    }
  }
}

// What a search for loops cannot place it leaves out; the asan build tells of who reads on.
TEST(GraphMutation, ScansThatLieInSubmapsFarAwayAreLeftOut) {
  for (const std::size_t submap : {std::size_t{0}, std::size_t{1}}) {
    GraphReading reading = read_graph(test::small_graph());
    ASSERT_TRUE(reading.graph);
    const std::size_t submaps = reading.graph->slam.closing.submaps.size();
    ASSERT_GT(submaps, 6U);
    for (auto& [number, node] : reading.graph->slam.nodes)
      if (node.placement.submap + 3 >= submaps) node.placement.submap = submap;
    go_on(std::move(*reading.graph));
  }
}

TEST(GraphMutation, IsRefusedInWordsOrGoneOnWith) {
  const char* asked = std::getenv("BANDWAGON_GRAPH_MUTATIONS");
  const int count = asked == nullptr ? 20000 : std::atoi(asked);
  const std::string& whole = test::small_graph();
  bw::test::FileMutator mutate(35);
  int read = 0;
  for (int i = 0; i < count; ++i) {
    std::string bytes = mutate(whole);
    if (mutate.below(2) == 0) bytes = test::sealed(std::move(bytes));  // as somebody would make who means it
    largest_allocation = 0;
    GraphReading reading = read_graph(bytes);
    ASSERT_LE(largest_allocation, 2 * bytes.size() + 4096) << "mutation " << i;
    if (!reading.graph) {
      ASSERT_NE(reading.fault.find("byte "), std::string::npos) << "mutation " << i << ": " << reading.fault;
      continue;
    }
    ++read;
    ASSERT_EQ(graph_bytes(*reading.graph), bytes) << "mutation " << i;
    if (read % 50 == 0) go_on(std::move(*reading.graph));
  }
  std::printf("%d mutations of %zu bytes: %d refused, %d read\n", count, whole.size(), count - read, read);
  EXPECT_GT(read, count / 20);
  EXPECT_GT(count - read, count / 2);
}

}  // namespace
}  // namespace bw::slam
