// The people component with two lasers of half a view each, front and rear, and with a camera that tells of
// whole people; in lock-step, by the simulated world.
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <gtest/gtest.h>
#include <people_msgs/msg/people.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/messages/geometry.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::GroundTruth;
using bandwagon_msgs::msg::Tracks;
using people_msgs::msg::People;

/// The robot stands at the origin of a room; odom is map. Front and rear laser see half a turn each, at their
/// own rates.
std::string room(const std::string& waypoints, const std::string& people, const std::string& inputs = "") {
  return R"(
robot:
  sensors:
    - {frame: laser, x: 0.2, y: 0.0, theta: 0.0}
    - {frame: laser_rear, x: -0.2, y: 0.0, theta: 3.141592653589793}
    - {frame: camera, x: 0.1, y: 0.05, theta: 0.5}
components:
  world:
    parameters:
      walls:
        - {x1: -7.0, y1: -4.0, x2: 7.0, y2: -4.0}
        - {x1: 7.0, y1: -4.0, x2: 7.0, y2: 4.0}
        - {x1: 7.0, y1: 4.0, x2: -7.0, y2: 4.0}
        - {x1: -7.0, y1: 4.0, x2: -7.0, y2: -4.0}
      laser: {field_of_view: 3.14, beams: 480}
      more_lasers: [{topic: scan_rear, field_of_view: 3.14, beams: 480, rate: 12.5}]
      people: {scripted: [)" +
         waypoints + R"(]}
  robot_base: {inputs: {wheel_commands: {external: true}}}
  people: {parameters: {)" +
         people + "}, inputs: {" + inputs + "}}\n";
}

const char* const kBoth = "scan_topics: [scan, scan_rear]";

struct Record {
  std::vector<Tracks> tracks;
  std::map<std::int64_t, GroundTruth> truths;  ///< by stamp
  std::string diagnosis;                       ///< of people, the last
};

using Spoil = std::function<void(People&)>;

/// `camera`: makes what it tells of the truth wrong; null: there is none.
Record record_of(const std::string& graph, double seconds, const Spoil& camera = {}) {
  Record record;
  run_with_script(graph, seconds, [&](Setup& setup) {
    setup.input<Tracks>("tracks", Qos::standard(50),
                        [&](const Tracks& m, const Tick&) { record.tracks.push_back(m); });
    setup.input<diagnostic_msgs::msg::DiagnosticArray>(
        "/diagnostics", Qos::standard(),
        [&](const auto& m, const Tick&) {
          for (const auto& status : m.status())
            if (status.name() == "people") record.diagnosis = status.message();
        },
        Need::optional);
    Output<People> told;
    if (camera) told = setup.output<People>("people_detections");
    setup.input<GroundTruth>(
        "sim/ground_truth", Qos::standard(50), [&, told](const GroundTruth& m, const Tick& tick) {
          record.truths[from_stamp(m.header().stamp()).nanoseconds] = m;
          if (!camera || tick.sequence % 5 != 0) return;  // 10 Hz
          const Pose2 X_camera_map = inverse(from_pose(m.pose()) * Pose2{0.1, 0.05, 0.5});
          People message;
          message.header(make_header("camera", from_stamp(m.header().stamp())));
          for (const auto& person : m.people()) {
            auto& out = message.people().emplace_back();
            out.position(to_point(X_camera_map * Vector2(person.position().x(), person.position().y())));
            out.reliability(0.9);
          }
          camera(message);
          told.publish(message);
        });
  });
  return record;
}

double after_start(const Tracks& tracks) { return seconds_since_start(from_stamp(tracks.header().stamp())); }

/// Confirmed tracks of all messages from `from` [s] on, by id; each must be where the only person truly is,
/// within 0.3 m.
std::set<std::uint32_t> ids_of_the_only_person(const Record& record, double from, int& messages) {
  std::set<std::uint32_t> ids;
  messages = 0;
  for (const Tracks& tracks : record.tracks) {
    if (after_start(tracks) < from) continue;
    const auto truth = record.truths.find(from_stamp(tracks.header().stamp()).nanoseconds);
    if (truth == record.truths.end()) continue;
    const auto& person = truth->second.people().at(0).position();
    int confirmed = 0;
    for (const auto& track : tracks.tracks()) {
      if (track.confidence() < 0.5) continue;
      ++confirmed;
      ids.insert(track.id());
      EXPECT_NEAR(track.position().x(), person.x(), 0.3) << after_start(tracks);
      EXPECT_NEAR(track.position().y(), person.y(), 0.3) << after_start(tracks);
    }
    EXPECT_EQ(confirmed, 1) << after_start(tracks);
    ++messages;
  }
  return ids;
}

const char* const kWalksBehind = "{waypoints: [{x: -1.5, y: -3.0}, {x: -3.0, y: 3.0}], speed: 0.8}";
const char* const kPasses = "{waypoints: [{x: 3.5, y: 1.2}, {x: -3.5, y: 1.5}], speed: 1.0}";

TEST(PeopleSensors, WhoWalksBehindIsSeenByTheRearLaserAlone) {
  int messages = 0;
  const auto ids = ids_of_the_only_person(record_of(room(kWalksBehind, kBoth), 5.0), 1.0, messages);
  EXPECT_EQ(ids.size(), 1U);
  EXPECT_GT(messages, 60);  // 10 and 12.5 sweeps a second, but for those of one time
  for (const Tracks& tracks : record_of(room(kWalksBehind, ""), 5.0).tracks)
    EXPECT_TRUE(tracks.tracks().empty());
}

TEST(PeopleSensors, WhoPassesFromFrontToRearKeepsTheirId) {
  int messages = 0;
  const Record both = record_of(room(kPasses, kBoth), 6.5);
  EXPECT_EQ(ids_of_the_only_person(both, 1.0, messages).size(), 1U);
  EXPECT_GT(messages, 80);
  Time last;
  for (const Tracks& tracks : both.tracks) {  // in order, and each time once
    EXPECT_GT(from_stamp(tracks.header().stamp()), last);
    last = from_stamp(tracks.header().stamp());
  }
}

TEST(PeopleSensors, SameSeedSameTracks) {
  const std::string graph = room(kPasses, std::string(kBoth) + ", people_topics: [people_detections]");
  const Record a = record_of(graph, 3.0, [](People&) {});
  const Record b = record_of(graph, 3.0, [](People&) {});
  ASSERT_GT(a.tracks.size(), 30U);
  EXPECT_EQ(a.tracks, b.tracks);
}

const char* const kCamera = "people_topics: [people_detections]";

// Behind the robot, where the front laser does not see them.
TEST(PeopleSensors, WhomOnlyTheCameraSeesIsAPerson) {
  int messages = 0;
  const Record seen = record_of(room(kWalksBehind, kCamera), 5.0, [](People&) {});
  EXPECT_EQ(ids_of_the_only_person(seen, 1.0, messages).size(), 1U);
  EXPECT_GT(messages, 35);
  EXPECT_EQ(seen.diagnosis, "looking");
}

TEST(PeopleSensors, CameraAloneWithoutAnyLaser) {
  int messages = 0;
  const Record seen =
      record_of(room(kWalksBehind, std::string("scan_topics: [], ") + kCamera), 5.0, [](People&) {});
  EXPECT_EQ(ids_of_the_only_person(seen, 1.0, messages).size(), 1U);
  EXPECT_GT(messages, 35);
}

TEST(PeopleSensors, CameraAndLaserSeeOnePersonNotTwo) {
  int messages = 0;
  const auto graph = room("{waypoints: [{x: 2.0, y: -3.0}, {x: 3.0, y: 3.0}], speed: 0.8}", kCamera);
  EXPECT_EQ(ids_of_the_only_person(record_of(graph, 6.0, [](People&) {}), 1.0, messages).size(), 1U);
  EXPECT_GT(messages, 45);
}

// Of each message that is not used nobody comes, and diagnostics says what is wrong.
TEST(PeopleSensors, MessagesThatAreNotOfNowOrNowhereAreNotUsed) {
  const auto moved = [](People& m, double seconds) {
    m.header().stamp(to_stamp(from_stamp(m.header().stamp()) + Duration::seconds(seconds)));
  };
  const std::vector<std::pair<std::string, Spoil>> faults = {
      {"its stamp is not of now", [&](People& m) { moved(m, -0.7); }},
      {"its stamp is not of now", [&](People& m) { moved(m, 3.0); }},
      {"it has no stamp", [](People& m) { m.header().stamp({}); }},
      {"no transform from 'moon' to odom", [](People& m) { m.header().frame_id("moon"); }},
      {"it tells of more than 200 people", [](People& m) { m.people().resize(201, m.people().at(0)); }}};
  for (const auto& [why, spoil] : faults) {
    const Record seen = record_of(room(kWalksBehind, kCamera), 2.1, spoil);
    ASSERT_GT(seen.tracks.size(), 15U) << why;
    for (const Tracks& tracks : seen.tracks) EXPECT_TRUE(tracks.tracks().empty()) << why;
    EXPECT_EQ(seen.diagnosis, "people of 'people_detections' are not used: " + why);
  }
}

TEST(PeopleSensors, ASilentCameraIsOnlyMissing) {
  const Record seen = record_of(room(kPasses, kCamera), 2.6);
  EXPECT_GT(seen.tracks.size(), 20U);
  EXPECT_FALSE(seen.tracks.back().tracks().empty());
  EXPECT_EQ(seen.diagnosis, "nobody is heard on 'people_detections'");
}

TEST(PeopleSensors, ALaserThatIsSilentIsSaidAndTheOtherGoesOn) {
  const Record seen =
      record_of(room(kPasses, "scan_topics: [scan, scan_left]", "scan_left: {external: true}"), 2.6);
  EXPECT_GT(seen.tracks.size(), 20U);
  EXPECT_FALSE(seen.tracks.back().tracks().empty());
  EXPECT_EQ(seen.diagnosis, "no scan of 'scan_left' to look at");
}

TEST(PeopleSensors, TopicsAreNamesAndEachIsNamedOnce) {
  for (const std::string topics :
       {"scan_topics: []", "scan_topics: [scan, scan]", "scan_topics: ['']", "people_topics: [scan]"})
    EXPECT_THROW(record_of(room(kPasses, topics), 0.1), std::runtime_error) << topics;
}

}  // namespace
}  // namespace bw
