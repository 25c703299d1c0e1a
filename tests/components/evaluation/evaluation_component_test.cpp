#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <bandwagon_msgs/msg/comfort.hpp>
#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/score_card.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/obstacles.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using namespace bandwagon_msgs::msg;
using ::testing::HasSubstr;

/// A drive of 4 m at 1 m/s from 1 s to 5 s past a person 1.0 m aside; the goal ends with `status`.
std::vector<ScoreCard> cards(const std::string& parameters, std::uint8_t end_status, double seconds = 6.0,
                             double xy_tolerance = 0.0, double goal_x = 4.0) {
  std::vector<ScoreCard> list;
  run_with_script("components: {evaluation: {parameters: " + parameters + "}}", seconds,
                  [&](bw::Setup& setup) {
                    setup.input<ScoreCard>("score_card", Qos::standard(50),
                                           [&](const auto& card, const Tick&) { list.push_back(card); });
                    setup.every(Duration::milliseconds(20), "world",
                                [=, truth = setup.output<GroundTruth>("sim/ground_truth"),
                                 navigation = setup.output<NavigationStatus>("navigation_status"),
                                 walls = setup.output<Obstacles>("sim/obstacles", Qos::latched()),
                                 map = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched())](
                                    const Tick& tick) mutable {
                                  const double t = seconds_since_start(tick.now);
                                  if (tick.sequence == 0) {
                                    nav_msgs::msg::OccupancyGrid grid;
                                    grid.info().resolution(0.5F);
                                    grid.info().width(20);
                                    grid.info().height(10);
                                    grid.info().origin().position().x(-3.0);
                                    grid.info().origin().position().y(-2.5);
                                    grid.data().assign(200, 0);
                                    map.publish(grid);
                                    const StaticObstacles wall{.segments = {{{1.0, 2.0}, {3.0, 2.0}}}};
                                    walls.publish(to_message(wall, Pose2{}, "map", tick.now));
                                  }
                                  NavigationStatus status;
                                  status.goal_id(1);
                                  status.goal().pose(to_pose({goal_x, 0, 0}));
                                  status.xy_tolerance(xy_tolerance);
                                  status.status(NavigationStatus_Constants::EXECUTING);
                                  if (std::abs(t - 1.0) < 1e-6) navigation.publish(status);
                                  status.status(end_status);
                                  status.reason("as told");
                                  GroundTruth message;
                                  message.header(make_header("map", tick.now));
                                  message.pose(to_pose({std::clamp(t - 1.0, 0.0, 4.0), 0, 0}));
                                  message.twist().linear().x(t > 1.0 && t < 5.0 ? 1.0 : 0.0);
                                  message.wall_clearance(1.7);
                                  GroundTruthPerson person;
                                  person.id(3);
                                  person.position(to_point({2.0, 1.0}));
                                  person.radius(0.3);
                                  message.people().push_back(person);
                                  truth.publish(message);
                                  if (std::abs(t - 5.0) < 1e-6) navigation.publish(status);
                                });
                  });
  return list;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return (std::stringstream() << in.rdbuf()).str();
}

TEST(EvaluationComponent, ScoresTheDriveAndDrawsIt) {
  const auto svg = std::filesystem::path(::testing::TempDir()) / "evaluation" / "run.svg";
  std::filesystem::remove(svg);
  const auto list =
      cards("{svg: '" + svg.string() + "', title: A test}", NavigationStatus_Constants::SUCCEEDED);
  ASSERT_GE(list.size(), 9U);  // twice a second for 4 s, and the final one
  EXPECT_FALSE(list.front().finished());
  const ScoreCard& card = list.back();
  EXPECT_TRUE(card.finished());
  EXPECT_TRUE(card.reached());
  EXPECT_NEAR(card.time_to_goal_s(), 4.0, 1e-6);
  EXPECT_NEAR(card.path_length_m(), 4.0, 0.021);
  EXPECT_NEAR(card.closest_person_m(), 0.4, 1e-6);  // 1.0 - 0.3 - 0.3
  EXPECT_NEAR(card.min_distance_m(), 0.4, 1e-6);
  EXPECT_NEAR(card.max_collision_index(), std::exp(-1.0 / 0.72), 1e-6);
  EXPECT_EQ(card.collisions(), 0U);

  EXPECT_THAT(text_of(svg), HasSubstr("goal reached"));
  EXPECT_THAT(text_of(svg), HasSubstr("A test"));
  EXPECT_THAT(text_of(svg), HasSubstr("0.40 m at"));
}

TEST(EvaluationComponent, AnAbortedGoalKeepsItsReason) {
  const auto list = cards("{}", NavigationStatus_Constants::ABORTED);
  ASSERT_FALSE(list.empty());
  EXPECT_TRUE(list.back().finished());
  EXPECT_FALSE(list.back().reached());
  EXPECT_EQ(list.back().reason(), "as told");
}

TEST(EvaluationComponent, ARunThatEndsEarlyStillHasItsPicture) {
  const auto svg = std::filesystem::path(::testing::TempDir()) / "early.svg";
  std::filesystem::remove(svg);
  const auto list = cards("{svg: '" + svg.string() + "'}", NavigationStatus_Constants::SUCCEEDED, 3.0);
  EXPECT_FALSE(list.back().finished());
  EXPECT_THAT(text_of(svg), HasSubstr(">ended early<"));
}

// The run is over after 3 s, and the graph knows it: the picture says so, and shows the wall the world told
// of, which is in no map.
TEST(EvaluationComponent, ADriveThatTheLimitEndsIsATimeoutAmongTheWorldsWalls) {
  const auto svg = std::filesystem::path(::testing::TempDir()) / "late.svg";
  std::filesystem::remove(svg);
  cards("{svg: '" + svg.string() + "', time_limit: 3.0}", NavigationStatus_Constants::SUCCEEDED, 3.0);
  EXPECT_THAT(text_of(svg), HasSubstr(">timeout<"));
  EXPECT_THAT(text_of(svg), HasSubstr("stroke-width=\"4\" stroke-linecap=\"round\""));
}

// 0.25 m from the goal: by the usual tolerance of 0.2 m within 0.1 m of it; by one of 0.1 m not, unless the
// judge has a figure of its own.
TEST(EvaluationComponent, JudgesByTheNavigatorsTolerance) {
  const auto reached = [](const std::string& parameters, double xy_tolerance) {
    return cards(parameters, NavigationStatus_Constants::SUCCEEDED, 6.0, xy_tolerance, 4.25).back().reached();
  };
  EXPECT_TRUE(reached("{}", 0.0));  // says nothing: the usual
  EXPECT_TRUE(reached("{}", 0.2));
  EXPECT_TRUE(reached("{}", 1.0));
  EXPECT_FALSE(reached("{}", 0.1));
  EXPECT_TRUE(reached("{goal_tolerance: 0.3}", 0.1));
  EXPECT_FALSE(reached("{goal_tolerance: 0.2}", 1.0));
}

// Beside a recording: no goal, a reference of positions alone at 10 Hz, an opinion 0.25 m to the left of it
// at 20 Hz.
TEST(Evaluation, ScoresAWholeRunAgainstAReferenceWithoutHeading) {
  const std::filesystem::path svg = std::filesystem::path(::testing::TempDir()) / "recorded_run.svg";
  std::vector<ScoreCard> list;
  run_with_script("components: {evaluation: {parameters: {scored: run, svg: " + svg.string() + "}}}", 4.0,
                  [&list](bw::Setup& setup) {
                    setup.input<ScoreCard>("score_card", Qos::standard(50),
                                           [&](const auto& card, const Tick&) { list.push_back(card); });
                    setup.every(Duration::milliseconds(50), "robot",
                                [truth = setup.output<GroundTruth>("sim/ground_truth"),
                                 pose = setup.output<nav_msgs::msg::Odometry>("odometry/filtered")](
                                    const Tick& tick) mutable {
                                  const double t = seconds_since_start(tick.now);
                                  nav_msgs::msg::Odometry opinion;
                                  opinion.header(make_header("map", tick.now));
                                  opinion.pose().pose(to_pose({0.5 * t, 0.25, 0.0}));
                                  pose.publish(opinion);
                                  if (tick.sequence % 2 != 0) return;
                                  GroundTruth message;
                                  message.header(make_header("map", tick.now));
                                  message.pose().position(to_point({0.5 * t, 0.0}));
                                  message.pose().orientation().w(0.0);
                                  message.twist().linear().x(std::nan(""));
                                  message.twist().angular().z(std::nan(""));
                                  message.wall_clearance(std::numeric_limits<double>::infinity());
                                  truth.publish(message);
                                });
                  });
  ASSERT_FALSE(list.empty());
  const ScoreCard& card = list.back();
  EXPECT_GT(card.localization_poses(), 60U);
  EXPECT_NEAR(card.localization_mean_m(), 0.25, 1e-9);
  EXPECT_NEAR(card.localization_max_m(), 0.25, 1e-9);
  EXPECT_TRUE(std::isnan(card.localization_rms_rad()));
  EXPECT_FALSE(card.reached());
  EXPECT_NEAR(card.mean_speed_mps(), 0.5, 1e-6);
  EXPECT_EQ(card.rms_jerk_mps3(), 0.0);
  const std::string picture = text_of(svg);
  EXPECT_THAT(picture, HasSubstr("<svg"));
  EXPECT_THAT(picture, testing::Not(HasSubstr("nan")));
}

/// What is told of comfort while `publish` is called every 20 ms with the seconds since the start.
template <class Neighbours>
std::vector<Comfort> comforts(Neighbours neighbours, double seconds) {
  std::vector<Comfort> list;
  run_with_script("components: {evaluation: {parameters: {scored: run}}}", seconds, [&](bw::Setup& setup) {
    setup.input<Comfort>("comfort", Qos::standard(50),
                         [&](const auto& message, const Tick&) { list.push_back(message); });
    setup.every(Duration::milliseconds(20), "neighbours",
                [publish = neighbours(setup)](const Tick& tick) mutable { publish(tick.now); });
  });
  return list;
}

// Past somebody who stands 1.0 m aside of the line, at 1 m/s: of 10 samples a second the one abreast is at a
// gap of
// 1.0 - 0.3 - 0.3. The world counts a contact from 2 s on.
TEST(Evaluation, TellsComfortByTheTruth) {
  const auto list = comforts(
      [](bw::Setup& setup) {
        return [truth = setup.output<GroundTruth>("sim/ground_truth")](Time now) {
          const double t = seconds_since_start(now);
          GroundTruth message;
          message.header(make_header("map", now));
          message.pose(to_pose({t, 0.0, 0.0}));
          message.twist().linear().x(-1.0);
          message.wall_clearance(std::numeric_limits<double>::infinity());
          message.contacts(t > 2.0 ? 1 : 0);
          GroundTruthPerson person;
          person.radius(0.3);
          person.id(8);
          person.position(to_point({20.0, 0.0}));
          message.people().push_back(person);
          person.id(3);
          person.position(to_point({2.0, 1.0}));
          message.people().push_back(person);
          truth.publish(message);
        };
      },
      4.0);
  EXPECT_NEAR(static_cast<double>(list.size()), 39.0, 2.0);
  double closest = 9.0;
  for (const Comfort& comfort : list) {
    const double t = seconds_since_start(from_stamp(comfort.header().stamp()));
    const double d = std::hypot(2.0 - t, 1.0);
    EXPECT_EQ(comfort.header().frame_id(), "map");
    EXPECT_EQ(comfort.source(), Comfort_Constants::TRUTH);
    EXPECT_EQ(comfort.closest_person_id(), 3U);
    EXPECT_NEAR(comfort.closest_person_m(), d - 0.6, 1e-9);
    EXPECT_NEAR(comfort.collision_index(), std::exp(-d * d / 0.72), 1e-9);
    EXPECT_EQ(comfort.comfort_limit(), 0.14);
    EXPECT_EQ(comfort.physical_limit(), 0.54);
    EXPECT_EQ(comfort.speed_mps(), 1.0);
    EXPECT_EQ(comfort.contacts(), t > 2.01 ? 1U : 0U) << t;
    closest = std::min(closest, comfort.closest_person_m());
  }
  EXPECT_NEAR(closest, 0.4, 1e-3);  // at most 20 ms from abreast
}

// No truth, as on a real robot: tracks in odom, and odometry in odom and in map. Somebody walks at 1 m/s
// across, told 0.2 s late; the gap is that of now. Tracks that end at 2 s count for half a second.
TEST(Evaluation, TellsComfortByTracksWhereThereIsNoTruth) {
  const auto list = comforts(
      [](bw::Setup& setup) {
        return [odometry = setup.output<nav_msgs::msg::Odometry>("odom"),
                filtered = setup.output<nav_msgs::msg::Odometry>("odometry/filtered"),
                tracks = setup.output<Tracks>("tracks")](Time now) {
          const double t = seconds_since_start(now);
          nav_msgs::msg::Odometry robot;
          robot.header(make_header("odom", now));
          robot.pose().pose(to_pose({1.0, 0.0, 0.0}));
          robot.twist().twist().linear().x(0.25);
          odometry.publish(robot);
          robot.header(make_header("map", now));
          robot.pose().pose(to_pose({50.0, 0.0, 0.0}));
          filtered.publish(robot);
          if (t > 2.0) return;
          Tracks people;
          people.header(make_header("odom", now - Duration::milliseconds(200)));
          Track track;
          track.confidence(1.0);
          track.id(5);
          track.radius(0.25);
          track.position(to_point({1.0, 2.0 + t - 0.2}));
          track.velocity(to_vector3({0.0, 1.0}));
          people.tracks().push_back(track);
          track.id(6);  // nearer, and perhaps furniture
          track.confidence(0.4);
          track.position(to_point({1.0, 1.0}));
          people.tracks().push_back(track);
          tracks.publish(people);
        };
      },
      4.0);
  ASSERT_GE(list.size(), 18U);
  for (const Comfort& comfort : list) {
    const double t = seconds_since_start(from_stamp(comfort.header().stamp()));
    EXPECT_EQ(comfort.header().frame_id(), "odom");
    EXPECT_EQ(comfort.source(), Comfort_Constants::TRACKS);
    EXPECT_EQ(comfort.closest_person_id(), 5U);
    EXPECT_NEAR(comfort.closest_person_m(), 2.0 + t - 0.3 - 0.25, 0.021) << t;  // one step of 20 ms at 1 m/s
    EXPECT_EQ(comfort.speed_mps(), 0.25);
    EXPECT_EQ(comfort.contacts(), 0U);
    EXPECT_LT(t, 2.35);  // 2 s, less 0.2 s, and 0.5 s
  }
}

// Nobody around: infinitely far. A position that is no number is not told of.
TEST(Evaluation, TellsNothingOfATruthThatIsNone) {
  const auto list = comforts(
      [](bw::Setup& setup) {
        return [truth = setup.output<GroundTruth>("sim/ground_truth")](Time now) {
          GroundTruth message;
          message.header(make_header("map", now));
          message.pose().orientation().w(1.0);
          message.pose().position().x(seconds_since_start(now) < 1.0 ? std::nan("") : 0.0);
          truth.publish(message);
        };
      },
      2.0);
  ASSERT_FALSE(list.empty());
  EXPECT_GE(seconds_since_start(from_stamp(list.front().header().stamp())), 0.99);
  for (const Comfort& comfort : list) {
    EXPECT_EQ(comfort.closest_person_m(), std::numeric_limits<double>::infinity());
    EXPECT_EQ(comfort.closest_person_id(), 0U);
    EXPECT_EQ(comfort.collision_index(), 0.0);
  }
}

}  // namespace
}  // namespace bw
