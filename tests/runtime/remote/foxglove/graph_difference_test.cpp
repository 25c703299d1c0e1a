#include "runtime/remote/foxglove/graph_difference.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace bw::foxglove {
namespace {

using NodesOf = std::map<std::string, std::set<std::string>>;

TEST(GraphDifference, NothingChanged) {
  const ConnectionGraph graph = {{{"/a", {"x"}}}, {{"/a", {"y"}}}, {{"/s", {"x"}}}};
  EXPECT_TRUE(difference(graph, graph).is_empty());
  EXPECT_FALSE(difference({}, graph).is_empty());
}

TEST(GraphDifference, WholeEntriesReplaceOlderOnes) {
  const auto found =
      difference({{{"/a", {"x"}}, {"/b", {"x"}}}, {}, {}}, {{{"/a", {"x", "y"}}, {"/b", {"x"}}}, {}, {}});
  EXPECT_EQ(found.changed.published, (NodesOf{{"/a", {"x", "y"}}}));
  EXPECT_TRUE(found.removed_topics.empty());
}

TEST(GraphDifference, ATopicIsRemovedWhenBothEndsAreGone) {
  const auto half = difference({{{"/a", {"x"}}}, {{"/a", {"y"}}}, {}}, {{}, {{"/a", {"y"}}}, {}});
  EXPECT_EQ(half.changed.published, (NodesOf{{"/a", {}}}));
  EXPECT_TRUE(half.removed_topics.empty());
  const auto whole = difference({{{"/a", {"x"}}}, {{"/a", {"y"}}}, {{"/s", {"x"}}}}, {});
  EXPECT_TRUE(whole.changed.published.empty());
  EXPECT_EQ(whole.removed_topics, std::vector<std::string>{"/a"});
  EXPECT_EQ(whole.removed_services, std::vector<std::string>{"/s"});
}

/// As a client applies it.
void apply(ConnectionGraph& graph, const GraphDifference& news) {
  const auto replace = [](NodesOf& entries, const NodesOf& changed) {
    for (const auto& [name, nodes] : changed) {
      if (nodes.empty())
        entries.erase(name);
      else
        entries[name] = nodes;
    }
  };
  replace(graph.published, news.changed.published);
  replace(graph.subscribed, news.changed.subscribed);
  replace(graph.services, news.changed.services);
  for (const std::string& topic : news.removed_topics) {
    graph.published.erase(topic);
    graph.subscribed.erase(topic);
  }
  for (const std::string& service : news.removed_services) graph.services.erase(service);
}

TEST(GraphDifference, AClientThatAppliesAllHasTheGraph) {
  std::mt19937 random(1);
  const auto some = [&random] {
    NodesOf entries;
    for (const char* name : {"/a", "/b", "/c"}) {
      for (const char* node : {"x", "y"}) {
        if (random() % 2 == 0) entries[name].insert(node);
      }
    }
    return entries;
  };
  ConnectionGraph told, now;
  for (int i = 0; i < 1000; ++i) {
    const ConnectionGraph next = {some(), some(), some()};
    apply(told, difference(now, next));
    now = next;
    ASSERT_EQ(told.published, now.published);
    ASSERT_EQ(told.subscribed, now.subscribed);
    ASSERT_EQ(told.services, now.services);
  }
}

}  // namespace
}  // namespace bw::foxglove
