// The section `faults` of a graph file, and when a fault acts.
#include "runtime/graph/fault_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/parameters/yaml_file.hpp"
#include "tests/runtime/graph_files.hpp"

namespace bw {
namespace {

std::vector<FaultSettings> faults_of(const std::string& yaml) {
  std::vector<Violation> violations;
  auto faults = read_faults(parse_yaml(yaml, "g.yaml"), violations);
  throw_if_any(std::move(violations));
  return faults;
}

std::string said(const std::string& yaml) {
  try {
    faults_of(yaml);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FaultSettings, AreReadFromTheGraph) {
  const auto faults = faults_of(R"(
blind: {kind: laser_silent, from: 5s, for: 200ms, every: 30s, topic: front/scan, namespace: robot1}
lost: {of: planning, parameters: {share: 0.5}}
left_out: {kind: lost, enabled: false}
)");
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].name, "blind");
  EXPECT_EQ(faults[0].kind, "laser_silent");
  EXPECT_EQ(faults[0].from, Duration::milliseconds(5000));
  EXPECT_EQ(faults[0].lasts, Duration::milliseconds(200));
  EXPECT_EQ(faults[0].every, Duration::milliseconds(30'000));
  EXPECT_EQ(faults[0].topic, "front/scan");
  EXPECT_EQ(faults[0].node_namespace, "robot1");
  EXPECT_EQ(faults[1].kind, "lost");  // the name
  EXPECT_EQ(faults[1].of, "planning");
  EXPECT_NE(faults[1].parameters.find("share"), nullptr);
  EXPECT_EQ(faults[1].where.line, 3);
}

TEST(FaultSettings, ActInTheirTimeAgainAndAgain) {
  const FaultSettings once{.from = Duration::milliseconds(20), .lasts = Duration::milliseconds(10)};
  EXPECT_FALSE(once.occurrence_at(Duration::milliseconds(19)));
  EXPECT_EQ(once.occurrence_at(Duration::milliseconds(20)), 0);
  EXPECT_EQ(once.occurrence_at(Duration::milliseconds(29)), 0);
  EXPECT_FALSE(once.occurrence_at(Duration::milliseconds(30)));
  const FaultSettings to_the_end{.from = Duration::milliseconds(20)};
  EXPECT_EQ(to_the_end.occurrence_at(Duration::milliseconds(1'000'000)), 0);
  FaultSettings often = once;
  often.every = Duration::milliseconds(100);
  EXPECT_EQ(often.occurrence_at(Duration::milliseconds(225)), 2);
  EXPECT_FALSE(often.occurrence_at(Duration::milliseconds(230)));
  EXPECT_EQ(often.beginning_of(2), Duration::milliseconds(220));
}

TEST(FaultSettings, AreRefusedWithFileLineKeyValueAndRule) {
  EXPECT_EQ(said("[lost]"), "g.yaml:1: faults = a list: must be a map of faults");
  EXPECT_EQ(said("f: soon"),
            "g.yaml:1: faults.f = soon: must be a map, such as {kind: laser_silent, from: 5s, for: 3s}");
  EXPECT_EQ(said("f: {from: soon}"),
            "g.yaml:1: faults.f.from = soon: must be a duration between 0 s and 604800 s, such as 5s");
  EXPECT_EQ(said("f: {for: 0}"),
            "g.yaml:1: faults.f.for = 0: must be a duration between 0.001 s and 604800 s, such as 5s");
  EXPECT_EQ(said("f: {for: 2s, every: 1s}"), "g.yaml:1: faults.f.every = 1s: needs a `for` that is shorter");
  EXPECT_EQ(said("f: {every: 1s}"), "g.yaml:1: faults.f.every = 1s: needs a `for` that is shorter");
  EXPECT_EQ(said("f: {knid: lost}"), "g.yaml:1: faults.f.knid: unknown key; did you mean 'kind'?");
  EXPECT_EQ(
      said("f: {colour: a}"),
      "g.yaml:1: faults.f.colour: unknown key; known: kind, enabled, from, for, every, topic, namespace, of, "
      "parameters");
  EXPECT_EQ(said("f: {parameters: 3}"), "g.yaml:1: faults.f.parameters = 3: must be a map of parameters");
}

TEST(LoadGraph, TakesFaultsFromTheGraphAFileAndTheCommandLine) {
  const Folder folder;
  const auto path = folder.write("g.yaml", "faults: {f: {kind: lost, from: 1s}}\ncomponents: {world: }\n");
  const auto from = [&](const std::vector<std::string>& set) {
    return load_graph(path, set).shared.at("faults").map.front().value.find("from")->scalar;
  };
  EXPECT_EQ(from({}), "1s");
  EXPECT_EQ(from({"faults.f.from=7s"}), "7s");
  const auto file = folder.write("f.yaml", "g: {kind: late, from: 3s}\n");
  EXPECT_EQ(from({"faults=" + file.string()}), "3s");
  EXPECT_EQ(from({"faults=" + file.string(), "faults.g.from=4s"}), "4s");
}

}  // namespace
}  // namespace bw
