// Ours and Nav2's server of one name on one domain: the second is not brought up, and who comes later is told of.
#include <memory>

#include <gmock/gmock.h>

#include "tests/interop/stand_in.hpp"

namespace bw::test {
namespace {

const plain::ServiceType kPathCheck = {
    .name = "nav2_msgs/srv/IsPathValid", .request_hash = {}, .response_hash = {}};

/// A foreign node that serves is_path_valid.
struct Foreign {
  explicit Foreign(const std::string& name) : node(name), server(node, "/is_path_valid", kPathCheck) {
    node.announce();
  }
  plain::Node node;
  plain::Server server;
};

bool holds(const plain::Bytes& bytes, const std::string& text) {
  return std::search(bytes.begin(), bytes.end(), text.begin(), text.end()) != bytes.end();
}

TEST(Namesakes, BesideAServerOfItsNameItIsNotActivated) {
  auto theirs = std::make_unique<Foreign>("planner_server");
  StandIn ours("planner_server");
  Outsider outside;
  ASSERT_TRUE(ours.says("/planner_server is there twice: a node of participant 01.0f."));
  EXPECT_TRUE(ours.says("of this machine has the same name and serves /is_path_valid too"));
  EXPECT_TRUE(outside.change("/planner_server", kConfigure));
  EXPECT_FALSE(outside.change("/planner_server", kActivate));
  EXPECT_EQ(outside.state("/planner_server"), kInactive);
  EXPECT_TRUE(ours.says("activate failed, now inactive: /planner_server is there twice"));
  theirs.reset();
  ASSERT_TRUE(ours.says("/planner_server has no rival any more"));
  EXPECT_TRUE(outside.change("/planner_server", kActivate));
  EXPECT_EQ(outside.state("/planner_server"), kActive);

  // Another server comes while ours is active, under another name.
  auto* rosout = outside.listen("/rosout", "rcl_interfaces/msg/Log");
  auto* diagnostics = outside.listen("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray");
  const std::string sentence =
      "/is_path_valid of /planner_server is served twice: by /other of participant 01.0f.";
  theirs = std::make_unique<Foreign>("other");
  EXPECT_TRUE(Outsider::hears(rosout, [&](const plain::Bytes& bytes) {
    if (!holds(bytes, sentence)) return false;
    plain::CdrIn cdr(bytes);
    cdr.number<std::int32_t>();
    cdr.number<std::uint32_t>();
    EXPECT_EQ(cdr.number<std::uint8_t>(), 40) << "ERROR";
    return true;
  }));
  EXPECT_TRUE(
      Outsider::hears(diagnostics, [&](const plain::Bytes& bytes) { return holds(bytes, sentence); }));
  EXPECT_EQ(outside.state("/planner_server"), kActive) << "a robot that drives is not stopped for it";
  EXPECT_EQ(ours.stop(), 0) << ours.process().err();
}

}  // namespace
}  // namespace bw::test
