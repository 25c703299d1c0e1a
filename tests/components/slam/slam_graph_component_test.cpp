// A map of a room that is saved, gone on with from another place, and "start from here"; in lock-step.
// Truth: the circle that the robot drives.
#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <vector>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <nav_msgs/srv/get_map.hpp>
#include <slam_toolbox/srv/deserialize_pose_graph.hpp>
#include <slam_toolbox/srv/save_map.hpp>
#include <slam_toolbox/srv/serialize_pose_graph.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/slam/files/graph_disk.hpp"
#include "runtime/host/actor.hpp"
#include "tests/components/service_calls.hpp"
#include "tests/components/slam/slam_room.hpp"
#include "tests/folder.hpp"

namespace bw {
namespace {

using geometry_msgs::msg::PoseWithCovarianceStamped;
using nav_msgs::srv::GetMap;
using slam_toolbox::srv::DeserializePoseGraph;
using slam_toolbox::srv::SaveMap;
using slam_toolbox::srv::SerializePoseGraph;
using namespace slam::test;

struct Click {
  double seconds;  ///< a multiple of 0.02
  Pose2 X_MB;
};

struct GraphScript {
  std::filesystem::path folder;
  std::string parameters;  ///< more of them
  std::vector<TimedRequest<SerializePoseGraph>> saves;
  std::vector<TimedRequest<DeserializePoseGraph>> reads;
  std::vector<Click> clicks;
  double seconds = 20.0;
  double begins = 0.0;   ///< [s] along the circle, where the robot stands first
  double carried = 0.0;  ///< [s] along the circle that it is carried on at 10 s, unseen by odometry
};

struct Told {
  double seconds = 0.0;
  Pose2 X_MB;
};

struct GraphSeen {
  std::vector<Told> poses;
  std::vector<std::vector<std::int8_t>> maps;
  std::vector<SerializePoseGraph::Response> saved;
  std::vector<DeserializePoseGraph::Response> read;
  std::vector<std::string> messages;  ///< of diagnostics
  std::string remark;                 ///< on initialpose, the last
};

Pose2 truth_of(const GraphScript& script, double t) {
  return truth_at(script.begins + t + (t >= 10.0 ? script.carried : 0.0));
}

/// Odometry each time, a scan every fifth.
class RoomRobot {
 public:
  explicit RoomRobot(Setup& setup)
      : scan_(setup.output<sensor_msgs::msg::LaserScan>("scan", Qos::sensor())),
        odom_(setup.output<nav_msgs::msg::Odometry>("odom")),
        tf_static_(setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched())) {}

  void publish(const Tick& tick, const Pose2& X_MB, const Pose2& X_OB) {
    if (tick.sequence == 0) {
      tf2_msgs::msg::TFMessage mounts;
      mounts.transforms().push_back(to_transform("base_link", "laser", tick.now, kMount));
      tf_static_.publish(mounts);
    }
    if (tick.sequence % 5 == 0) scan_.publish(room_scan(X_MB, tick.now, false));
    nav_msgs::msg::Odometry message;
    message.header(make_header("odom", tick.now));
    message.child_frame_id("base_link");
    message.pose().pose(to_pose(X_OB));
    odom_.publish(message);
  }

 private:
  Output<sensor_msgs::msg::LaserScan> scan_;
  Output<nav_msgs::msg::Odometry> odom_;
  Output<tf2_msgs::msg::TFMessage> tf_static_;
};

GraphSeen drive(const GraphScript& script) {
  GraphSeen seen;
  const std::string yaml =
      "components: {slam: {parameters: {folder: " + script.folder.string() + script.parameters + "}}}";
  run_with_script(yaml, script.seconds, [&](Setup& setup) {
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "map", Qos::latched(), [&](const auto& m, const Tick&) { seen.maps.push_back(m.data()); });
    setup.input<
        nav_msgs::msg::Odometry>("odometry/filtered", Qos::standard(50), [&](const auto& m, const Tick&) {
      seen.poses.push_back({seconds_since_start(from_stamp(m.header().stamp())), from_pose(m.pose().pose())});
    });
    setup.input<diagnostic_msgs::msg::DiagnosticArray>(
        "/diagnostics", Qos::standard(),
        [&](const auto& m, const Tick&) {
          for (const auto& status : m.status()) {
            if (status.name().find("slam") == std::string::npos) continue;
            seen.messages.push_back(status.message());
            for (const auto& value : status.values())
              if (value.key() == "initialpose") seen.remark = value.value();
          }
        },
        Need::optional);
    call_at<SerializePoseGraph>(setup, "slam_toolbox/serialize_map", script.saves, seen.saved);
    call_at<DeserializePoseGraph>(setup, "slam_toolbox/deserialize_map", script.reads, seen.read);
    setup.every(Duration::milliseconds(20), "robot",
                [&script, robot = RoomRobot(setup),
                 click = setup.output<PoseWithCovarianceStamped>("initialpose")](const Tick& tick) mutable {
                  const double t = seconds_since_start(tick.now);
                  robot.publish(tick, truth_of(script, t), odometry_at(t));
                  for (const Click& c : script.clicks) {
                    if (std::abs(t - c.seconds) > 0.001) continue;
                    PoseWithCovarianceStamped pose;
                    pose.header(make_header("map", tick.now));
                    pose.pose().pose(to_pose(c.X_MB));
                    click.publish(pose);
                  }
                });
  });
  return seen;
}

SerializePoseGraph::Request save(const std::string& name) {
  SerializePoseGraph::Request request;
  request.filename(name);
  return request;
}

DeserializePoseGraph::Request go_on_with(const std::string& name, std::int8_t match, const Pose2& X_MB = {}) {
  DeserializePoseGraph::Request request;
  request.filename(name);
  request.match_type(match);
  request.initial_pose().x(X_MB.x);
  request.initial_pose().y(X_MB.y);
  request.initial_pose().theta(X_MB.theta);
  return request;
}

namespace match = slam_toolbox::srv::DeserializePoseGraph_Request_Constants;
namespace result = slam_toolbox::srv::SerializePoseGraph_Response_Constants;

/// Largest distance from the truth from `first` seconds on [m].
double worst_from(const GraphSeen& seen, const GraphScript& script, double first) {
  double worst = 0.0;
  for (const Told& told : seen.poses)
    if (told.seconds >= first)
      worst = std::max(worst, (told.X_MB.position() - truth_of(script, told.seconds).position()).norm());
  return worst;
}

/// Twice round, and the map as it was saved then.
class SlamGraphs : public testing::Test {
 protected:
  void SetUp() override {
    const GraphSeen seen = drive({.folder = folder_ / "", .saves = {{38.0, save("room")}}, .seconds = 39.0});
    ASSERT_EQ(seen.saved.size(), 1U);
    ASSERT_EQ(seen.saved[0].result(), result::RESULT_SUCCESS);
  }
  bw::test::Folder folder_;
};

TEST_F(SlamGraphs, FindItsPlaceInTheWholeMap) {
  const GraphScript script{.folder = folder_ / "",
                           .reads = {{0.5, go_on_with("room", match::UNSET)}},
                           .seconds = 20.0,
                           .begins = 7.0};
  const GraphSeen seen = drive(script);
  ASSERT_EQ(seen.read.size(), 1U);
  EXPECT_EQ(seen.read[0].structure_needs_at_least_one_member(), 0);
  // Until then a map of its own; from when it knows where it is, that of the file.
  EXPECT_LT(worst_from(seen, script, 10.0), 0.06);
  EXPECT_NEAR(seen.poses.back().seconds, 20.0, 0.1);
  EXPECT_GT(std::ranges::count_if(seen.messages, [](const std::string& m) { return m == "OK: mapping"; }), 9);
}

TEST_F(SlamGraphs, GoOnFromAGivenPoseThatIsSomeDecimetresOff) {
  const Pose2 X_MB = truth_at(9.5);
  const GraphScript script{.folder = folder_ / "",
                           .saves = {{18.0, save("both")}},
                           .reads = {{0.5, go_on_with("room.posegraph", match::START_AT_GIVEN_POSE,
                                                      {X_MB.x + 0.3, X_MB.y - 0.3, X_MB.theta + 0.2})}},
                           .seconds = 19.0,
                           .begins = 9.0};
  const GraphSeen seen = drive(script);
  EXPECT_LT(worst_from(seen, script, 0.8), 0.06);
  // The two drives are one map.
  const slam::SavedGraph one = slam::read_graph_file(folder_ / "room.posegraph");
  const slam::SavedGraph both = slam::read_graph_file(folder_ / "both.posegraph");
  EXPECT_GT(both.slam.nodes.size(), one.slam.nodes.size() + 20);
  EXPECT_EQ(
      std::ranges::count_if(both.slam.closing.submaps, [](const auto& s) { return s.found_in.has_value(); }),
      1);
}

TEST_F(SlamGraphs, GoOnFromTheFirstScan) {
  const GraphScript script{.folder = folder_ / "",
                           .reads = {{0.02, go_on_with("room", match::START_AT_FIRST_NODE)}},
                           .seconds = 8.0};
  const GraphSeen seen = drive(script);
  EXPECT_LT(worst_from(seen, script, 0.5), 0.06);
}

// What cannot be read, or has no place, is refused, and the drive goes on bit by bit as without.
TEST_F(SlamGraphs, GoesOnAsBeforeWhenAFileCannotBeRead) {
  std::string bytes;
  {
    std::ifstream file(folder_ / "room.posegraph", std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  std::ofstream(folder_ / "cut.posegraph", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  bytes[8] = 7;
  std::ofstream(folder_ / "other.posegraph", std::ios::binary) << bytes;
  const GraphScript plain{.folder = folder_ / "", .seconds = 8.0};
  GraphScript script = plain;
  script.reads = {{2.0, go_on_with("cut", match::UNSET)},
                  {2.5, go_on_with("other", match::UNSET)},
                  {3.0, go_on_with("none", match::UNSET)},
                  {3.5, go_on_with("../room", match::UNSET)},
                  {4.0, go_on_with("room", 9)},
                  {4.5, go_on_with("room", match::START_AT_GIVEN_POSE, {NAN, 0.0, 0.0})}};
  script.saves = {{5.0, save("room")}};
  const GraphSeen without = drive(plain);
  const GraphSeen with = drive(script);
  ASSERT_EQ(with.read.size(), 6U);
  for (const auto& response : with.read) EXPECT_EQ(response.structure_needs_at_least_one_member(), 255);
  ASSERT_EQ(with.saved.size(), 1U);
  EXPECT_EQ(with.saved[0].result(), result::RESULT_FAILED_TO_WRITE_FILE) << "it is there";
  ASSERT_EQ(with.poses.size(), without.poses.size());
  for (std::size_t k = 0; k < with.poses.size(); ++k)
    ASSERT_EQ(with.poses[k].X_MB, without.poses[k].X_MB) << k;
  EXPECT_EQ(with.maps, without.maps);
}

/// Who reads `map` keeps its writer until it is let go, as a network or a disk may do.
class HeldMap final : public SampleTap {
 public:
  void connect(const std::vector<const OutputEnd*>&) override {}
  void on_sample(const OutputEnd& output, Time, std::span<const std::uint8_t>) override {
    if (output.topic == "/map") is_let_go_.wait(false);
  }
  void let_go() {
    is_let_go_ = true;
    is_let_go_.notify_all();
  }
  bool is_let_go() const { return is_let_go_; }

 private:
  std::atomic<bool> is_let_go_ = false;
};

// In real time one thread tells the map, answers, and writes files. While it is held up three scans are handled; then
// all three answers come, and the files are there.
TEST(SlamInRealTime, HandlesScansWhileTheMapIsSaved) {
  const bw::test::Folder folder;
  const auto path = scratch_file("slam_in_real_time");
  std::ofstream(path) << "components: {slam: {parameters: {folder: " << (folder / "").string() << "}}}";
  const auto held = std::make_shared<HeldMap>();
  int poses = -1;  // since the services were called
  std::vector<std::string> answers;
  std::vector<ExtraComponent> extra;
  extra.push_back(
      {"script", std::make_unique<Script>([&](bw::Setup& setup) {
         setup.input<PoseWithCovarianceStamped>("pose", Qos::standard(), [&](const auto&, const Tick&) {
           if (poses >= 0 && ++poses == 3) held->let_go();
         });
         const auto answered = [&, finish = setup.finish_run()](const std::string& what, bool ok) {
           answers.push_back(what + (ok ? "" : " failed") + (held->is_let_go() ? "" : " before the scans"));
           if (answers.size() < 3) return;
           held->let_go();
           finish(true, "saved");
         };
         setup.every(Duration::milliseconds(20), "robot",
                     [&, answered, robot = RoomRobot(setup),
                      graph = setup.client<SerializePoseGraph>("slam_toolbox/serialize_map"),
                      grid = setup.client<SaveMap>("slam_toolbox/save_map"),
                      shown = setup.client<GetMap>("slam_toolbox/dynamic_map")](const Tick& tick) mutable {
                       const double t = 0.02 * static_cast<double>(tick.sequence);
                       robot.publish(tick, truth_at(t), odometry_at(t));
                       if (tick.sequence != 50) return;
                       poses = 0;
                       const Duration patience = Duration::seconds(20.0);
                       graph.call(save("room"), patience,
                                  [answered](const SerializePoseGraph::Response* r, const Tick&) {
                                    answered("graph", r != nullptr && r->result() == result::RESULT_SUCCESS);
                                  });
                       SaveMap::Request room;
                       room.name().data("room");
                       grid.call(room, patience, [answered](const SaveMap::Response* r, const Tick&) {
                         answered("grid", r != nullptr && r->result() == 0);
                       });
                       shown.call({}, patience, [answered](const GetMap::Response* r, const Tick&) {
                         answered("shown", r != nullptr && r->map().info().width() > 100);
                       });
                     });
       })});
  Host host(load_graph(path, {}), {.clock = ClockMode::wall, .tap = held}, std::move(extra));
  host.run(Duration::seconds(30.0));
  std::filesystem::remove(path);
  EXPECT_THAT(answers, testing::UnorderedElementsAre("graph", "grid", "shown"));
  EXPECT_GT(slam::read_graph_file(folder / "room.posegraph").slam.nodes.size(), 0U);
  EXPECT_TRUE(std::filesystem::exists(folder / "room.yaml"));
}

// Carried a third of the circle on, unseen by odometry; somebody says where it is, half a metre off.
TEST(SlamInitialPose, StartsFromHere) {
  const bw::test::Folder folder;
  GraphScript script{.folder = folder / "", .seconds = 20.0, .begins = 0.0, .carried = 6.0};
  script.seconds = 30.0;
  const Pose2 X_MB = truth_of(script, 12.0);
  script.clicks = {{12.0, {X_MB.x - 0.4, X_MB.y + 0.3, wrap_angle(X_MB.theta - 0.2)}}};
  const GraphSeen seen = drive(script);
  EXPECT_THAT(seen.remark, testing::Not(testing::HasSubstr("kept")));
  EXPECT_LT(worst_from(seen, script, 14.0), 0.1);
}

// In the yard, ten metres from the room: the pose stays what it was.
TEST(SlamInitialPose, KeepsThePoseWhereTheScanDoesNotFit) {
  const bw::test::Folder folder;
  const GraphScript plain{.folder = folder / "", .seconds = 15.0};
  GraphScript script = plain;
  script.clicks = {{10.0, {0.0, 14.0, 0.0}}};
  const GraphSeen without = drive(plain);
  const GraphSeen with = drive(script);
  EXPECT_THAT(with.remark, testing::HasSubstr("does not fit the map there, the pose was kept"));
  ASSERT_EQ(with.poses.size(), without.poses.size());
  for (std::size_t k = 0; k < with.poses.size(); ++k)
    ASSERT_EQ(with.poses[k].X_MB, without.poses[k].X_MB) << k;
}

// Carried 3 m on along the circle at 10 s, unseen by odometry: half a second later it looks for its place, finds
// it, and says for five seconds what was; the map is that of the room.
TEST(SlamHealth, AKidnappedRobotSaysSoAndSparesTheMap) {
  const bw::test::Folder folder;
  const GraphScript script{.folder = folder / "", .seconds = 30.0, .carried = 6.0};
  const GraphSeen seen = drive(script);
  const auto is_lost = [](const std::string& m) {
    return m.starts_with("LOST: kidnapped") || m.starts_with("DEGRADED: was carried away");
  };
  const auto first = std::ranges::find_if(seen.messages, is_lost);
  ASSERT_NE(first, seen.messages.end());
  EXPECT_LE(first - seen.messages.begin(), 12) << "a message a second, the robot was carried at 10 s";
  EXPECT_GE(first - seen.messages.begin(), 9);
  EXPECT_NEAR(static_cast<double>(std::ranges::count_if(seen.messages, is_lost)), 5.0, 1.0);
  EXPECT_EQ(seen.messages.back(), "OK: mapping");
  EXPECT_LT(worst_from(seen, script, 11.0), 0.1);
  const GraphSeen calm = drive({.folder = folder / "", .seconds = 30.0});
  const auto walls = [](const GraphSeen& s) { return std::ranges::count(s.maps.back(), 100); };
  EXPECT_LT(10 * walls(seen), 11 * walls(calm));
  EXPECT_TRUE(std::ranges::none_of(calm.messages, is_lost));
}

}  // namespace
}  // namespace bw
