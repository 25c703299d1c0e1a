// Paths and ids as goals of follow_path bring them.
#include "components/local_planner/follow_path/received_path.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/local_planner/follow_path/plugin_choice.hpp"

namespace bw {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = std::numbers::pi;

TEST(ReceivedPath, HeadingsFollowThePathAndTheGoalKeepsItsOwn) {
  // NavFn leaves all but the last heading at 0.
  const ReceivedPath path = received_path({{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 2.5}});
  ASSERT_TRUE(path.fault.empty());
  ASSERT_EQ(path.poses.size(), 4U);
  EXPECT_DOUBLE_EQ(path.poses[0].theta, kPi / 2);
  EXPECT_DOUBLE_EQ(path.poses[1].theta, kPi);
  EXPECT_DOUBLE_EQ(path.poses[2].theta, -kPi / 2);
  EXPECT_DOUBLE_EQ(path.poses[3].theta, 2.5);
}

TEST(ReceivedPath, IsThinnedToACentimetreAndKnowsWhereItsPosesCameFrom) {
  std::vector<Pose2> fine;
  for (int i = 0; i < 100'000; ++i) fine.push_back({20.0 * i / 99'999, 0.0, 0.0});
  const ReceivedPath path = received_path(fine);
  // Of 20 m in steps of 0.2 mm each 51st pose is more than 1 cm on: 1961, and the goal.
  EXPECT_LE(path.poses.size(), 2000U);
  EXPECT_GE(path.poses.size(), 1950U);
  ASSERT_EQ(path.index.size(), path.poses.size());
  for (std::size_t i = 0; i < path.poses.size(); ++i) EXPECT_EQ(path.poses[i].x, fine[path.index[i]].x) << i;
  EXPECT_EQ(path.index.back(), 99'999U);
}

TEST(ReceivedPath, OnePoseAndRepeatedPosesAreAPath) {
  EXPECT_EQ(received_path({{1, 2, 0.5}}).poses, (std::vector<Pose2>{{1, 2, 0.5}}));
  EXPECT_EQ(received_path({{1, 2, 0}, {1, 2, 0}, {1, 2, 0.5}}).poses, (std::vector<Pose2>{{1, 2, 0.5}}));
}

TEST(ReceivedPath, WhatIsNoPathIsSaidInOneSentence) {
  EXPECT_EQ(received_path({}).fault, "the path is empty");
  EXPECT_EQ(received_path({{0, 0, 0}, {kNan, 0, 0}}).fault, "pose 1 of the path is not finite");
  EXPECT_EQ(received_path({{0, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}}).fault,
            "pose 1 of the path is not finite");
  EXPECT_EQ(received_path({{0, 0, 0}, {1, 0, kNan}}).fault, "the last pose of the path has no orientation");
  EXPECT_TRUE(received_path({{0, 0, kNan}, {1, 0, 0}}).fault.empty()) << "its heading is not used";
}

TEST(ReceivedPath, PathErrorsAreThoseOfNav2) {
  // In lyrical's TrackingFeedback left of the path is positive, and a path that leads to the robot's left.
  const std::vector<Pose2> north = {{1, 0, kPi / 2}, {1, 1, kPi / 2}};
  const PathOffset error = path_offset(north, 0, {0.5, 0.2, 0.0});
  EXPECT_DOUBLE_EQ(error.position, 0.5);
  EXPECT_DOUBLE_EQ(error.heading, kPi / 2);
}

TEST(PluginChoice, EmptyMeansTheOnlyOne) {
  FollowPathOptions options;
  EXPECT_EQ(unknown_plugin({}, options).fault, FollowFault::none);
  EXPECT_EQ(unknown_plugin({"FollowPath", "general_goal_checker", "progress_checker", "PathHandler"}, options)
                .fault,
            FollowFault::none);
  options.controller_plugins = {"FollowPath", "Careful"};
  const FollowFailure two = unknown_plugin({}, options);
  EXPECT_EQ(two.fault, FollowFault::invalid_controller);
  EXPECT_EQ(two.reason, "the goal names no controller, and there are FollowPath, Careful");
  EXPECT_EQ(unknown_plugin({.controller = "Careful"}, options).fault, FollowFault::none);
}

TEST(PluginChoice, WhatIsUnknownIsNamed) {
  FollowPathOptions options;
  const FollowFailure controller = unknown_plugin({.controller = "MPPI"}, options);
  EXPECT_EQ(controller.fault, FollowFault::invalid_controller);
  EXPECT_EQ(controller.reason, "the controller 'MPPI' is unknown; there is FollowPath");
  EXPECT_EQ(unknown_plugin({.goal_checker = "precise"}, options).fault, FollowFault::unknown);
  EXPECT_EQ(unknown_plugin({.path_handler = "other"}, options).fault, FollowFault::unknown);
  options.progress_checker_plugins.clear();
  EXPECT_EQ(unknown_plugin({}, options).fault, FollowFault::none);
  EXPECT_EQ(unknown_plugin({.progress_checker = "progress_checker"}, options).reason,
            "the progress checker 'progress_checker' is unknown; there is none");
}

}  // namespace
}  // namespace bw
