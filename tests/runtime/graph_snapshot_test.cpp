// The section `snapshot` of a graph file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/graph_files.hpp"

namespace bw {
namespace {

TEST(LoadGraph, ReadsTheSnapshotSection) {
  const Folder folder;
  const Graph graph = load_graph(folder.write("graphs/g.yaml", R"(
snapshot:
  keep: 20s
  memory: 64MB
  most: 3
  to: ../misses
  on:
    - contact
    - /bumper
    - {name: empty, topic: /battery_state, field: percentage, below: 0.2}
components: {world: }
)"));
  ASSERT_TRUE(graph.snapshot);
  const SnapshotSettings& s = *graph.snapshot;
  EXPECT_EQ(s.keep, Duration::milliseconds(20'000));
  EXPECT_EQ(s.after, Duration::milliseconds(20'000));
  EXPECT_EQ(s.memory, 64'000'000U);
  EXPECT_EQ(s.most, 3);
  EXPECT_EQ(s.to, folder.path() / "misses");
  ASSERT_EQ(s.on.size(), 3U);
  EXPECT_EQ(s.on[0].name, "contact");
  EXPECT_FALSE(s.on[0].own);
  EXPECT_EQ(s.on[0].where.line, 8);
  EXPECT_EQ(s.on[1].own->topic, "/bumper");
  EXPECT_TRUE(s.on[1].own->when.empty());
  EXPECT_EQ(s.on[2].name, "empty");
  ASSERT_EQ(s.on[2].own->when.size(), 1U);
  EXPECT_EQ(s.on[2].own->when[0].field, "percentage");
  EXPECT_EQ(s.on[2].own->when[0].rule, EventRule::below);
  EXPECT_EQ(s.on[2].own->when[0].number, 0.2);
  EXPECT_FALSE(load_graph(folder.write("graphs/h.yaml", "components: {world: }")).snapshot);
}

TEST(LoadGraph, RefusesASnapshotSectionInWords) {
  const auto said = [](const std::string& section) {
    return refusal("snapshot: " + section + "\ncomponents: {world: }\n");
  };
  EXPECT_EQ(said("30s"),
            "g.yaml:1: snapshot = 30s: must be a map, such as {keep: 30s, on: [contact], to: snapshots}");
  EXPECT_EQ(said("{to: x, keep: soon}"),
            "g.yaml:1: snapshot.keep = soon: must be a duration between 1 s and 3600 s, such as 30s");
  EXPECT_EQ(said("{to: x, after: 2h}"),
            "g.yaml:1: snapshot.after = 2h: must be a duration between 0 s and 3600 s, such as 30s");
  EXPECT_EQ(said("{to: x, memory: 100kB}"),
            "g.yaml:1: snapshot.memory = 100kB: must be a size of at least 1MB, such as 256MB");
  EXPECT_EQ(said("{to: x, most: 0}"), "g.yaml:1: snapshot.most = 0: must be between 1 and 10000");
  EXPECT_EQ(said("{keep: 30s}"), "g.yaml:1: snapshot.to: must name a folder");
  EXPECT_EQ(said("{to: x, kep: 30s}"), "g.yaml:1: snapshot.kep: unknown key; did you mean 'keep'?");
  EXPECT_EQ(said("{to: x, on: contact}"), "g.yaml:1: snapshot.on = contact: must be a list");
  EXPECT_EQ(said("{to: x, on: []}"),
            "g.yaml:1: snapshot.on = a list: must name an event; without `on` every declared one counts");
  EXPECT_EQ(
      said("{to: x, on: [/a//b]}"),
      "g.yaml:1: snapshot.on = /a//b: must be a topic name: letters, digits and _ between single /, no digit "
      "after a /");
  EXPECT_EQ(said("{to: x, on: [{topic: a}]}"), "g.yaml:1: snapshot.on.topic = a: must begin with /");
  const std::string together =
      "g.yaml:1: snapshot.on.field = a map: and one of is, is_not, above, below, begins_with, rises come together";
  EXPECT_EQ(said("{to: x, on: [{topic: /a, field: b}]}"), together);
  EXPECT_EQ(said("{to: x, on: [{topic: /a, above: 1}]}"), together);
  EXPECT_EQ(said("{to: x, on: [{topic: /a, field: b, above: 1, below: 3}]}"), together);
  EXPECT_EQ(said("{to: x, on: [{topic: /a, field: b, above: high}]}"),
            "g.yaml:1: snapshot.on.above = high: must be a number");
}

}  // namespace
}  // namespace bw
