// A client of one distribution at a server of another: the names match, the fields do not, and Humble sends
// no hash that could tell.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "components/messages/nav2_goals.hpp"
#include "tests/components/messages/every_nav2_message.hpp"
#include "tests/idl/cdr_writer.hpp"

namespace bw::test {
namespace {

constexpr std::uint64_t kSeed = 14;
constexpr int kPayloads = 100;

struct Taken {
  const char* ros_name;
  const char* cells;
};

/// Who takes whose random messages: y all of them, since the reader's fields fit into their first bytes,
/// mostly as the same fields; . none;
/// ? those that happen to look like its own, with empty lists, say. What is not named is the same everywhere,
/// hence taken.
constexpr Taken kTaken[] = {
    // from Humble, Jazzy, Kilted, Lyrical to each of the others
    {"nav2_msgs/action/FollowPath_SendGoal_Request", "... yy. yy. yyy"},
    {"nav2_msgs/action/FollowPath_GetResult_Response", "... yyy yyy yyy"},
    {"nav2_msgs/action/FollowPath_FeedbackMessage", "yy. yy. yy. yyy"},
    {"nav2_msgs/action/ComputePathToPose_SendGoal_Request", "yy. yy. yy. ???"},
    {"nav2_msgs/action/ComputePathToPose_GetResult_Response", "... yyy yyy yyy"},
    {"nav2_msgs/action/ComputePathThroughPoses_SendGoal_Request", "y.. y.. ..y ..y"},
    {"nav2_msgs/action/ComputePathThroughPoses_GetResult_Response", "... yy. yy. y.."},
    {"nav2_msgs/action/NavigateToPose_GetResult_Response", "... yyy yyy yyy"},
    {"nav2_msgs/action/NavigateToPose_FeedbackMessage", "yy. yy. yy. yyy"},
    {"nav2_msgs/action/NavigateThroughPoses_SendGoal_Request", "y.. y.. ..y ..y"},
    {"nav2_msgs/action/NavigateThroughPoses_GetResult_Response", "... y.. yyy yyy"},
    {"nav2_msgs/action/NavigateThroughPoses_FeedbackMessage", "y.. y.. yy. yy."},
    {"nav2_msgs/action/FollowWaypoints_SendGoal_Request", "... .yy .yy .yy"},
    {"nav2_msgs/action/FollowWaypoints_GetResult_Response", "... y?? y?y y?y"},
    {"nav2_msgs/action/Spin_SendGoal_Request", "y.. y.. yyy yyy"},
    {"nav2_msgs/action/Spin_GetResult_Response", "... yyy yyy yyy"},
    {"nav2_msgs/action/BackUp_SendGoal_Request", "y.. y.. yyy yyy"},
    {"nav2_msgs/action/BackUp_GetResult_Response", "... yyy yyy yyy"},
    {"nav2_msgs/action/DriveOnHeading_SendGoal_Request", "y.. y.. yyy yyy"},
    {"nav2_msgs/action/DriveOnHeading_GetResult_Response", "... yyy yyy yyy"},
    {"nav2_msgs/action/Wait_GetResult_Response", "... yyy yyy yyy"},
    {"nav2_msgs/srv/ClearEntireCostmap_Request", "yy. yy. yy. yyy"},
    {"nav2_msgs/srv/ClearEntireCostmap_Response", "yy? yy? yy? yyy"},
    {"nav2_msgs/srv/ClearCostmapAroundRobot_Request", "yy. yy. yy. yyy"},
    {"nav2_msgs/srv/ClearCostmapAroundRobot_Response", "yy? yy? yy? yyy"},
    {"nav2_msgs/srv/ClearCostmapExceptRegion_Request", "yy. yy. yy. yyy"},
    {"nav2_msgs/srv/ClearCostmapExceptRegion_Response", "yy? yy? yy? yyy"},
    {"nav2_msgs/srv/IsPathValid_Request", "y.. y.. yy. yyy"},
};

char expected(std::string_view ros_name, std::size_t pair) {
  const auto* row = std::find_if(std::begin(kTaken), std::end(kTaken),
                                 [&](const Taken& taken) { return taken.ros_name == ros_name; });
  return row == std::end(kTaken) ? 'y' : row->cells[pair + pair / 3];
}

/// `read`, as its reader writes it, is what was sent, but for padding of its own, which is zero.
bool is_within(const std::vector<std::uint8_t>& read, const std::vector<std::uint8_t>& sent) {
  return read.size() <= sent.size() &&
         std::equal(read.begin(), read.end(), sent.begin(),
                    [](std::uint8_t mine, std::uint8_t theirs) { return mine == theirs || mine == 0; });
}

/// y, . or ?. What a reader takes is a message of its own, where it takes all in the bytes that were sent;
/// what it refuses it gives a reason for.
char taken(const AnyMessage& from, const AnyMessage& to) {
  RandomPayload payload(kSeed, 3);
  int count = 0;
  int exact = 0;
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < kPayloads; ++i) {
    const std::vector<std::uint8_t> sent = payload(from.type());
    const auto message = to.fresh();
    std::string reason;
    if (!message->read(sent, &reason)) {
      EXPECT_NE(reason.find("(byte "), std::string::npos) << reason;
      continue;
    }
    ++count;
    message->write(bytes);
    const auto again = to.fresh();
    EXPECT_TRUE(again->read(bytes, nullptr) && again->equals(*message)) << to.type().ros_name;
    exact += is_within(bytes, sent) ? 1 : 0;
  }
  if (count == kPayloads) {
    EXPECT_EQ(exact, kPayloads) << from.type().ros_name;
  }
  return count == kPayloads ? 'y' : count == 0 ? '.' : '?';
}

TEST(Nav2MixedLayouts, AreTakenOrRefusedAsStated) {
  const std::array<Messages, 4> layouts = {every_nav2_message<HumbleNav2>(), every_nav2_message<JazzyNav2>(),
                                           every_nav2_message<KiltedNav2>(),
                                           every_nav2_message<LyricalNav2>()};
  std::size_t pair = 0;
  for (const Messages& from : layouts) {
    for (const Messages& to : layouts) {
      if (&from == &to) continue;
      for (std::size_t i = 0; i < from.size(); ++i) {
        const std::string_view name = from[i]->type().ros_name;
        EXPECT_EQ(taken(*from[i], *to[i]), expected(name, pair)) << name << ", pair " << pair;
      }
      ++pair;
    }
  }
  EXPECT_EQ(pair, 12U);
}

/// `message` as a reader of To has it; `reason` where it refuses.
template <class To, class From>
bool read_as(const From& message, To& read, std::string& reason) {
  std::vector<std::uint8_t> bytes;
  serialize(message, bytes);
  return deserialize(bytes, read, &reason);
}

// What is behind the reader's last field is not missed: Jazzy's server spins and keeps its checks on.
TEST(Nav2MixedLayouts, AYoungersWishIsNotHeardByAnOlderServer) {
  KiltedNav2::Spin::SendGoal::Request sent;
  sent.goal().target_yaw(1.5F);
  sent.goal().disable_collision_checks(true);
  JazzyNav2::Spin::SendGoal::Request read;
  std::string reason;
  ASSERT_TRUE(read_as(sent, read, reason)) << reason;
  EXPECT_EQ(read.goal().target_yaw(), 1.5F);
  EXPECT_FALSE(disables_collision_checks(read.goal()));
}

// Humble reads Jazzy's number of loops as the number of poses: with none it is a goal without poses.
TEST(Nav2MixedLayouts, JazzysWaypointsAreNoneForHumble) {
  JazzyNav2::FollowWaypoints::SendGoal::Request sent;
  sent.goal().poses().resize(2);
  HumbleNav2::FollowWaypoints::SendGoal::Request read;
  std::string reason;
  ASSERT_TRUE(read_as(sent, read, reason)) << reason;
  EXPECT_TRUE(goal_poses(read.goal()).empty());
  sent.goal().number_of_loops(3);
  EXPECT_FALSE(read_as(sent, read, reason));
}

// The number of via points, none, stands where Jazzy expects the planner id's length, and the id's length
// where it expects a boolean.
TEST(Nav2MixedLayouts, LyricalsPlanIsRefusedByJazzyWithByteAndRule) {
  LyricalNav2::ComputePathToPose::SendGoal::Request sent;
  sent.goal().planner_id("GridBased");
  JazzyNav2::ComputePathToPose::SendGoal::Request read;
  std::string reason;
  EXPECT_FALSE(read_as(sent, read, reason));
  EXPECT_EQ(
      reason,
      "nav2_msgs/action/ComputePathToPose_Goal.use_start: boolean is neither 0 nor 1 (byte 169 of 183)");
}

// Humble's client has no field for an error; Jazzy's misses it in a result of Humble's server.
TEST(Nav2MixedLayouts, OfAResultWithErrorHumbleReadsTheStatus) {
  JazzyNav2::NavigateToPose::GetResult::Response jazzys;
  jazzys.status(6);
  jazzys.result().error_code(208);
  HumbleNav2::NavigateToPose::GetResult::Response humbles;
  std::string reason;
  ASSERT_TRUE(read_as(jazzys, humbles, reason)) << reason;
  EXPECT_EQ(humbles.status(), 6);
  EXPECT_FALSE(read_as(humbles, jazzys, reason));
  EXPECT_EQ(reason, "nav2_msgs/action/NavigateToPose_Result.error_code: runs past the end (byte 6 of 6)");
}

}  // namespace
}  // namespace bw::test
