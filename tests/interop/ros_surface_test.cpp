// What ROS 2's tools look at, seen by a second participant: names, types, QoS, type hashes, and the bytes
// that announce nodes, in the formats of Humble and of Jazzy. Expected values: rmw's QoS profiles, hashes
// printed by Jazzy's own generator.
#include <algorithm>
#include <cstring>
#include <set>

#include <gmock/gmock.h>

#include "runtime/dds/participant.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/running_graph.hpp"

namespace bw::test {
namespace {

struct ExpectedEnd {
  std::string topic;
  std::string type;
  bool is_writer;
  Durability durability;
  std::string hash;
};

/// A topic of ROS 2, or one end of a service.
bool is_of_ros(const std::string& topic) {
  return topic.starts_with("rt/") || topic.starts_with("rq/") || topic.starts_with("rr/");
}

const std::vector<ExpectedEnd>& expected_ends() {
  constexpr auto kVolatile = Durability::volatile_;
  constexpr auto kLatched = Durability::transient_local;
  static const std::vector<ExpectedEnd> ends = {
      {"rt/odom", "nav_msgs::msg::dds_::Odometry_", true, kVolatile,
       "3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"},
      {"rt/scan", "sensor_msgs::msg::dds_::LaserScan_", true, kVolatile,
       "64c191398013af96509d518dac71d5164f9382553fce5c1f8cca5be7924bd828"},
      {"rt/tf", "tf2_msgs::msg::dds_::TFMessage_", true, kVolatile,
       "e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"},
      {"rt/joint_states", "sensor_msgs::msg::dds_::JointState_", true, kVolatile,
       "a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"},
      {"rt/cmd_vel", "geometry_msgs::msg::dds_::Twist_", false, kVolatile,
       "9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a"},
      {"rt/map", "nav_msgs::msg::dds_::OccupancyGrid_", true, kLatched,
       "8d348150c12913a31ee0ec170fbf25089e4745d17035792a1ba94d6f0bc0cfc7"},
      {"rt/rosout", "rcl_interfaces::msg::dds_::Log_", true, kLatched,
       "e28ce254ca8abc06abf92773b74602cdbf116ed34fbaf294fb9f81da9f318eac"},
      {"rt/parameter_events", "rcl_interfaces::msg::dds_::ParameterEvent_", true, kVolatile,
       "043e627780fcad87a22d225bc2a037361dba713fca6a6b9f4b869a5aa0393204"},
      {"rt/diagnostics", "diagnostic_msgs::msg::dds_::DiagnosticArray_", true, kVolatile,
       "5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e"},
  };
  return ends;
}

/// Reads rmw_dds_common/msg/ParticipantEntitiesInfo as CDR1 lays it out, with the given size of a gid; exact
/// to the last byte.
class EntitiesReader {
 public:
  EntitiesReader(std::vector<std::uint8_t> cdr, std::size_t gid_size)
      : cdr_(std::move(cdr)), gid_size_(gid_size) {
    EXPECT_THAT(std::vector(cdr_.begin(), cdr_.begin() + 4), testing::ElementsAre(0, 1, 0, 0));
  }
  dds::Guid gid() {
    dds::Guid guid{};
    std::memcpy(guid.data(), take(gid_size_), guid.size());
    for (std::size_t i = guid.size(); i < gid_size_; ++i) EXPECT_EQ(cdr_.at(at_ - gid_size_ + i), 0);
    return guid;
  }
  std::vector<dds::Guid> gids() {
    std::vector<dds::Guid> all(number());
    for (dds::Guid& guid : all) guid = gid();
    return all;
  }
  std::string text() {
    const std::uint32_t length = number();
    return {reinterpret_cast<const char*>(take(length)), length - 1};
  }
  std::uint32_t number() {
    at_ = (at_ + 3) / 4 * 4;
    std::uint32_t value = 0;
    std::memcpy(&value, take(4), 4);
    if (value > cdr_.size()) throw std::runtime_error("implausible length: the layout is another one");
    return value;
  }
  bool at_end() const { return at_ == cdr_.size(); }

 private:
  const std::uint8_t* take(std::size_t size) {
    if (at_ + size > cdr_.size()) throw std::runtime_error("too short");
    at_ += size;
    return cdr_.data() + (at_ - size);
  }
  std::vector<std::uint8_t> cdr_;
  std::size_t gid_size_;
  std::size_t at_ = 4;
};

class RosSurface : public testing::TestWithParam<std::pair<const char*, std::size_t>> {
 protected:
  RosSurface()
      : graph_(std::string(GetParam().first)), observer_({.network = dds::Network::from_environment({})}) {}

  std::optional<dds::Endpoint> find(const std::string& topic, bool is_writer) const {
    for (dds::Endpoint& end : observer_.endpoints()) {
      if (!end.is_local && end.topic == topic && end.is_writer == is_writer) return std::move(end);
    }
    return std::nullopt;
  }
  bool all_seen() const {
    return std::ranges::all_of(
        expected_ends(), [this](const auto& end) { return find(end.topic, end.is_writer).has_value(); });
  }

  RunningGraph graph_;
  dds::Participant observer_;
};

TEST_P(RosSurface, EndsCarryNamesTypesQosAndTypeHashes) {
  ASSERT_TRUE(eventually([this] { return all_seen(); })) << graph_.process().err();
  for (const ExpectedEnd& expected : expected_ends()) {
    const dds::Endpoint end = *find(expected.topic, expected.is_writer);
    EXPECT_EQ(end.type, expected.type);
    EXPECT_EQ(end.user_data, "typehash=RIHS01_" + expected.hash + ";") << end.topic;
    EXPECT_EQ(end.qos.reliability, Reliability::reliable) << end.topic << ": rviz2 asks for it by default";
    EXPECT_EQ(end.qos.durability, expected.durability) << end.topic;
  }
  EXPECT_EQ(find("rt/rosout", true)->qos.lifespan, Duration::seconds(10.0));
  EXPECT_EQ(graph_.stop(), 0);
}

TEST_P(RosSurface, NodesAreAnnouncedInTheBytesOfTheDistribution) {
  const auto reader = observer_.create_reader({.topic = "ros_discovery_info",
                                               .type = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_",
                                               .qos = Qos::latched(),
                                               .user_data = {}},
                                              [] {});
  dds::Sample sample;
  ASSERT_TRUE(eventually([&] { return reader->take(sample); })) << graph_.process().err();
  ASSERT_TRUE(eventually([this] { return all_seen(); }));

  EntitiesReader bytes(sample.cdr, GetParam().second);
  const dds::Guid participant = bytes.gid();
  EXPECT_THAT(observer_.remote_participants(), testing::Contains(participant));
  EXPECT_THAT(std::vector(participant.begin() + 12, participant.end()), testing::ElementsAre(0, 0, 1, 0xc1));

  // One each for all nodes of the process; both are told at each, where ROS 2's tools look for them.
  const dds::Guid parameter_events = find("rt/parameter_events", true)->guid;
  const dds::Guid rosout = find("rt/rosout", true)->guid;
  std::set<std::string> writers_of_parameter_events, writers_of_rosout;
  std::set<std::string> nodes;
  std::map<dds::Guid, std::string> owner;
  for (std::uint32_t left = bytes.number(); left > 0; --left) {
    const std::string node_namespace = bytes.text();
    const std::string name = bytes.text();
    EXPECT_EQ(node_namespace, "/");
    nodes.insert(name);
    for (int list = 0; list < 2; ++list) {
      for (const dds::Guid& guid : bytes.gids()) {
        const bool is_shared = guid == parameter_events || guid == rosout;
        EXPECT_TRUE(owner.emplace(guid, name).second || is_shared)
            << name << " shares an end with " << owner[guid];
        if (guid == parameter_events) writers_of_parameter_events.insert(name);
        if (guid == rosout) writers_of_rosout.insert(name);
      }
    }
  }
  EXPECT_TRUE(bytes.at_end());
  const std::string process = "bandwagon_" + std::to_string(graph_.process().id());
  EXPECT_EQ(nodes, (std::set<std::string>{process, "lifecycle_manager_navigation", "map_server",
                                          "motor_control", "robot_base", "world"}));
  EXPECT_EQ(writers_of_parameter_events, nodes);
  EXPECT_EQ(writers_of_rosout, nodes);
  EXPECT_EQ(owner[find("rt/odom", true)->guid], "robot_base");
  EXPECT_EQ(owner[find("rt/cmd_vel", false)->guid], "motor_control");
  EXPECT_EQ(owner[find("rt/map", true)->guid], "map_server");
  // Every end of a ROS topic belongs to one node, and every listed end exists.
  ASSERT_TRUE(eventually([&] {
    const auto ends = observer_.endpoints();
    return owner.size() == static_cast<std::size_t>(std::ranges::count_if(
                               ends, [](const auto& end) { return !end.is_local && is_of_ros(end.topic); }));
  }));
  for (const dds::Endpoint& end : observer_.endpoints()) {
    if (end.is_local || !is_of_ros(end.topic)) continue;
    EXPECT_TRUE(owner.contains(end.guid)) << end.topic << " belongs to no node";
  }
  EXPECT_EQ(graph_.stop(), 0);
}

INSTANTIATE_TEST_SUITE_P(Distributions, RosSurface,
                         testing::Values(std::pair{"humble", std::size_t{24}},
                                         std::pair{"jazzy", std::size_t{16}}),
                         [](const auto& instance) { return std::string(instance.param.first); });

}  // namespace
}  // namespace bw::test
