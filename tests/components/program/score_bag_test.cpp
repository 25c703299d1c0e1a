#include "components/program/score_bag.hpp"

#include <filesystem>
#include <functional>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <gmock/gmock.h>
#include <nav_msgs/msg/odometry.hpp>

#include "components/messages/geometry.hpp"
#include "components/program/score_report.hpp"
#include "runtime/recording/bag/bag_writer.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;

/// Five seconds along x of map at 1 m/s. The odometry's frame lies 10 m off and rotated by 90 degrees; a
/// person of 0.3 m stands at (2, 1) in map, and the localization believes to be 0.1 m to the left.
class RecordedDrive : public testing::Test {
 protected:
  void SetUp() override {
    path_ = std::filesystem::path(testing::TempDir()) / "score_bag_test.mcap";
    std::filesystem::remove(path_);
    writer_.emplace(path_, bag::BagWriterOptions{});
  }
  void TearDown() override { std::filesystem::remove(path_); }

  template <class Message>
  std::size_t topic(const std::string& name) {
    return writer_->add_topic({.name = name, .type = std::string(MessageTraits<Message>::ros_name)});
  }
  template <class Message>
  void write(std::size_t topic, Time time, const Message& message) {
    std::vector<std::uint8_t> cdr;
    serialize(message, cdr);
    writer_->write(topic, time, time, cdr);
  }

  void drive(
      bool with_truth, bool with_status, bool with_tracks, const std::function<void()>& at_the_end = [] {}) {
    using namespace bandwagon_msgs::msg;
    using namespace NavigationStatus_Constants;
    const std::size_t odom = topic<nav_msgs::msg::Odometry>("/odom");
    const std::size_t filtered = topic<nav_msgs::msg::Odometry>("/odometry/filtered");
    const std::size_t truth = with_truth ? topic<GroundTruth>("/sim/ground_truth") : 0;
    const std::size_t status = with_status ? topic<NavigationStatus>("/navigation_status") : 0;
    const std::size_t tracks = with_tracks ? topic<Tracks>("/tracks") : 0;
    const Pose2 X_MO{10.0, 0.0, 1.5707963267948966};
    for (int i = 0; i <= 50; ++i) {
      const Time now = Time::seconds(100.0 + 0.1 * i);
      const Pose2 X_MB{0.1 * i, 0.0, 0.0};
      const bool is_over = i == 50;
      NavigationStatus news = status_of(1, is_over ? SUCCEEDED : EXECUTING);
      if (with_status && i == 0) write(status, now, news);
      nav_msgs::msg::Odometry message;
      message.header(make_header("odom", now));
      message.pose().pose(to_pose(inverse(X_MO) * X_MB));
      write(odom, now, message);
      if (with_tracks) {
        Tracks seen;
        seen.header(make_header("odom", now));
        Track person;
        person.confidence(1.0);
        person.id(4);
        person.position(to_point(inverse(X_MO) * Vector2(2.0, 1.0)));
        person.radius(0.3);
        seen.tracks().push_back(person);
        write(tracks, now, seen);
      }
      GroundTruth true_state;
      true_state.header(make_header("map", now));
      true_state.pose(to_pose(X_MB));
      true_state.twist().linear().x(1.0);
      true_state.wall_clearance(2.0);
      if (someone_) {
        GroundTruthPerson person;
        person.id(9);
        person.position(to_point(*someone_));
        person.radius(0.3);
        true_state.people().push_back(person);
      }
      if (with_truth && i <= last_truth_) write(truth, now, true_state);
      message.header(make_header("map", now));
      message.pose().pose(to_pose({X_MB.x, 0.1, 0.0}));
      message.twist().twist().linear().x(1.0);
      write(filtered, now, message);
      if (with_status && i == preempted_at_) write(status, now, status_of(2, EXECUTING));
      if (with_status && is_over && ends_) {
        if (preempted_at_ >= 0) news = status_of(2, SUCCEEDED);
        write(status, now, news);
      }
    }
    at_the_end();
    writer_->close();
  }

  /// Of a goal at (5, 0).
  bandwagon_msgs::msg::NavigationStatus status_of(std::uint64_t id, std::uint8_t value) {
    namespace values = bandwagon_msgs::msg::NavigationStatus_Constants;
    bandwagon_msgs::msg::NavigationStatus news;
    news.header().frame_id("map");
    news.goal_id(id);
    news.goal().pose(to_pose({5.0, 0.0, 0.0}));
    news.status(value);
    news.reason(value == values::SUCCEEDED ? "reached" : "");
    return news;
  }

  BagScore score(const std::optional<Limits>& limits = std::nullopt) {
    return score_bag(*bag::open_bag(path_), {0.3, {}}, limits);
  }

  std::filesystem::path path_;
  std::optional<bag::BagWriter> writer_;
  std::optional<Vector2> someone_;  ///< stands there all the time
  bool ends_ = true;                ///< the status tells that the goal was reached
  int last_truth_ = 50;             ///< looks at 0.1 s
  int preempted_at_ = -1;           ///< by goal 2
};

TEST_F(RecordedDrive, ByTheTruth) {
  drive(true, true, true);
  const BagScore score = this->score();
  EXPECT_EQ(score.judged_by, "ground truth /sim/ground_truth");
  ASSERT_EQ(score.drives.size(), 1U);
  const ScoreCard& card = score.drives[0].card;
  EXPECT_TRUE(card.reached);
  EXPECT_NEAR(card.path_length, 5.0, 1e-9);
  EXPECT_NEAR(card.min_distance, 2.0, 1e-9) << "the truth knows nobody, only walls";
  EXPECT_NEAR(score.drives[0].pose_errors.rms_position(), 0.1, 1e-9);
}

// Somebody stands 0.5 m beside the path at x = 2: touched from x = 2 - sqrt(0.6^2 - 0.5^2) = 1.67 on, the
// first of ten looks a second at 1.7.
TEST_F(RecordedDrive, TellsWhoHitWhomAndJudgesByTheRobotsLimits) {
  someone_ = Vector2(2.0, 0.5);
  drive(true, true, true);
  const BagScore unknown = score();
  ASSERT_EQ(unknown.drives.at(0).contacts.size(), 1U);
  EXPECT_FALSE(unknown.drives[0].contacts[0].is_judged);
  const BagScore judged = score(Limits{});
  const JudgedContact& contact = judged.drives.at(0).contacts.at(0);
  EXPECT_EQ(contact.record.person, 9U);
  EXPECT_NEAR(contact.record.time, 1.7, 1e-6);
  EXPECT_EQ(contact.record.closing.who, WhoHit::robot_closing);
  EXPECT_TRUE(contact.is_judged);
  EXPECT_EQ(contact.verdict.avoidance, possible::Avoidance::avoidable);
  EXPECT_FALSE(is_excused(judged.drives[0].contacts, judged.drives[0].card.collisions));
}

// The robot believes to drive along y = 0.1 and sees the person where it is from there: 1.0 - 0.3 - 0.3 m
// aside.
TEST_F(RecordedDrive, ByWhatTheRobotBelievedAndSaw) {
  drive(false, true, true);
  const BagScore score = this->score();
  EXPECT_EQ(score.judged_by, "the robot's own /odometry/filtered and /tracks");
  ASSERT_EQ(score.drives.size(), 1U);
  const ScoreCard& card = score.drives[0].card;
  EXPECT_TRUE(card.finished && card.reached);
  EXPECT_NEAR(card.time_to_goal, 5.0, 1e-9);
  ASSERT_TRUE(card.closest);
  EXPECT_NEAR(card.closest->gap, 0.4, 0.01);  // the pose is a cycle old when the tracks come
  EXPECT_EQ(score.drives[0].pose_errors.count(), 0);
}

TEST_F(RecordedDrive, WithoutAGoalTheWholeBagIsOneDrive) {
  drive(false, false, false);
  const BagScore score = this->score();
  ASSERT_EQ(score.drives.size(), 1U);
  EXPECT_FALSE(score.drives[0].has_goal);
  EXPECT_NEAR(score.drives[0].card.path_length, 5.0, 1e-9);
  EXPECT_THAT(score.notes, testing::Contains(HasSubstr("no tracks")));
  EXPECT_THAT(score.notes, testing::Contains(HasSubstr("no navigation status")));
}

/// Not known, in JSON and in words, and exit status 3.
void expect_unknown(const BagScore& score, const std::string& why) {
  const ScoreReport report = report_of(score);
  EXPECT_EQ(report.exit_status, 3);
  EXPECT_TRUE(report.json["drives"].back()["reached"].is_null());
  EXPECT_EQ(report.json["unknown"], 1);
  EXPECT_EQ(report.json["successes"], 0);
  EXPECT_THAT(report.text, HasSubstr("Not known whether the goal was reached: " + why));
  EXPECT_THAT(report.text, testing::Not(HasSubstr("claims the goal but is not there")));
}

// The latched status of a goal that was reached before the bag comes first: nothing of its drive is in the
// bag, and nobody is accused.
TEST_F(RecordedDrive, AGoalThatWasOverBeforeTheBagIsNotKnown) {
  const std::size_t status = topic<bandwagon_msgs::msg::NavigationStatus>("/navigation_status");
  write(status, Time::seconds(99.0),
        status_of(1, bandwagon_msgs::msg::NavigationStatus_Constants::SUCCEEDED));
  drive(true, false, false);
  const BagScore score = this->score();
  ASSERT_EQ(score.drives.size(), 1U);
  expect_unknown(score,
                 "the robot claims the goal, and nothing tells where it was then. Nothing of the drive");
  const nlohmann::json card = report_of(score).json["drives"][0];
  for (const char* figure : {"path_length_m", "collisions", "min_distance_m", "time_to_goal_s", "contacts"})
    EXPECT_TRUE(card[figure].is_null()) << figure;
}

// One that was given up before the bag was not reached, by the robot's own word.
TEST_F(RecordedDrive, AGoalThatWasGivenUpBeforeTheBagWasNotReached) {
  const std::size_t status = topic<bandwagon_msgs::msg::NavigationStatus>("/navigation_status");
  auto news = status_of(1, bandwagon_msgs::msg::NavigationStatus_Constants::ABORTED);
  news.reason("blocked: a crowd");
  write(status, Time::seconds(99.0), news);
  drive(true, false, false);
  const ScoreReport report = report_of(score());
  EXPECT_EQ(report.exit_status, 1);
  EXPECT_EQ(report.json["drives"][0]["reached"], false);
  EXPECT_THAT(report.text, HasSubstr("Goal not reached: blocked: a crowd. Nothing of the drive"));
}

// The truth ends 3 s before the claim, at x = 2: that is not where the robot was then.
TEST_F(RecordedDrive, AClaimIsNotJudgedByAnOldTruth) {
  last_truth_ = 20;
  drive(true, true, false);
  const BagScore score = this->score();
  expect_unknown(score, "the robot claims the goal, and nothing tells where it was then");
  EXPECT_TRUE(report_of(score).json["drives"][0]["distance_to_goal_m"].is_null());
  EXPECT_NEAR(score.drives[0].card.path_length, 2.0, 1e-9);
}

TEST_F(RecordedDrive, ABagThatEndsBeforeTheGoalDoesNotTell) {
  ends_ = false;
  drive(true, true, false);
  const BagScore score = this->score();
  expect_unknown(score, "the bag ends before the drive; recorded over 5.00 m, 0 contacts");
}

// Goal 1 gives way to goal 2 at x = 2: 2 m are of the one, 3 m of the other, which is reached.
TEST_F(RecordedDrive, OfTwoGoalsEachIsADrive) {
  preempted_at_ = 20;
  drive(true, true, false);
  const BagScore score = this->score();
  ASSERT_EQ(score.drives.size(), 2U);
  EXPECT_FALSE(score.drives[0].card.reached);
  EXPECT_EQ(score.drives[0].card.reason, "preempted by goal 2");
  EXPECT_NEAR(score.drives[0].card.path_length, 2.0, 1e-9);
  EXPECT_TRUE(score.drives[1].card.reached);
  EXPECT_NEAR(score.drives[1].card.path_length, 2.9, 1e-9);
  EXPECT_EQ(report_of(score).exit_status, 1);
}

// Two goals of a list, the first over before the bag begins: of the whole drive the end alone is known.
TEST_F(RecordedDrive, AListWhoseBeginningIsMissingIsNotKnown) {
  const std::size_t status = topic<bandwagon_msgs::msg::NavigationStatus>("/navigation_status");
  namespace values = bandwagon_msgs::msg::NavigationStatus_Constants;
  auto first = status_of(1, values::SUCCEEDED);
  first.number_of_goals_remaining(1);
  write(status, Time::seconds(99.9), first);
  write(status, Time::seconds(99.95), status_of(2, values::EXECUTING));
  drive(true, false, false, [&] { write(status, Time::seconds(105.0), status_of(2, values::SUCCEEDED)); });
  expect_unknown(score(), "the robot claims an earlier goal, and nothing tells where it was then");
}

// Without a truth, and without an odometry in map: a position in odom says nothing of a goal in map.
TEST_F(RecordedDrive, AnOdometryInAnotherFrameDoesNotJudgeAClaim) {
  const std::size_t odom = topic<nav_msgs::msg::Odometry>("/odom");
  const std::size_t status = topic<bandwagon_msgs::msg::NavigationStatus>("/navigation_status");
  namespace values = bandwagon_msgs::msg::NavigationStatus_Constants;
  write(status, Time::seconds(100.0), status_of(1, values::EXECUTING));
  nav_msgs::msg::Odometry message;
  message.header(make_header("odom", Time::seconds(100.5)));
  write(odom, Time::seconds(100.5), message);
  write(status, Time::seconds(101.0), status_of(1, values::SUCCEEDED));
  writer_->close();
  const BagScore score = this->score();
  expect_unknown(score, "the robot claims the goal, and nothing tells where it was then");
  EXPECT_THAT(score.notes, testing::Contains(HasSubstr("/odom is in frame 'odom', goals are in 'map'")));
}

// The first that the bag hears is 12 s old.
TEST_F(RecordedDrive, ABagThatBeginsWithinADriveSaysSo) {
  const std::size_t status = topic<bandwagon_msgs::msg::NavigationStatus>("/navigation_status");
  auto news = status_of(1, bandwagon_msgs::msg::NavigationStatus_Constants::EXECUTING);
  news.navigation_time().sec(12);
  write(status, Time::seconds(99.9), news);
  drive(true, false, false, [&] {
    write(status, Time::seconds(105.0),
          status_of(1, bandwagon_msgs::msg::NavigationStatus_Constants::SUCCEEDED));
  });
  const BagScore score = this->score();
  EXPECT_TRUE(score.drives.at(0).card.reached);
  EXPECT_THAT(score.notes, testing::Contains(HasSubstr("begins 12.0 s into the drive to goal 1")));
}

TEST_F(RecordedDrive, WithNeitherTruthNorOdometryThereIsNothingToJudge) {
  writer_->add_topic({.name = "/odom", .type = "nav_msgs/msg/Odometry"});
  writer_->close();
  EXPECT_THROW(score(), std::runtime_error);
}

}  // namespace
}  // namespace bw
