#include "components/program/drive_page/shown_bag.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "runtime/recording/bag/known_type.hpp"
#include "runtime/recording/bag/mcap_writer.hpp"
#include "runtime/recording/bag/schema.hpp"

namespace bw {
namespace {

constexpr std::array<std::string_view, 24> kShown = {
    "bandwagon_msgs/msg/Comfort",
    "bandwagon_msgs/msg/GroundTruth",
    "bandwagon_msgs/msg/NavigationStatus",
    "bandwagon_msgs/msg/PlannerCycle",
    "bandwagon_msgs/msg/ScoreCard",
    "bandwagon_msgs/msg/Tracks",
    "diagnostic_msgs/msg/DiagnosticArray",
    "geometry_msgs/msg/PolygonStamped",
    "geometry_msgs/msg/PoseArray",
    "geometry_msgs/msg/PoseStamped",
    "geometry_msgs/msg/PoseWithCovarianceStamped",
    "geometry_msgs/msg/Twist",
    "geometry_msgs/msg/TwistStamped",
    "nav2_msgs/msg/CollisionMonitorState",
    "nav2_msgs/msg/ParticleCloud",
    "nav_msgs/msg/OccupancyGrid",
    "nav_msgs/msg/Odometry",
    "nav_msgs/msg/Path",
    "rcl_interfaces/msg/Log",
    "sensor_msgs/msg/LaserScan",
    "std_msgs/msg/String",
    "tf2_msgs/msg/TFMessage",
    "visualization_msgs/msg/Marker",
    "visualization_msgs/msg/MarkerArray",
};

class MemorySink final : public bag::ByteSink {
 public:
  void write(bag::BytesView bytes) override {
    if (bytes_.size() + bytes.size() > kLargestPageBag)
      throw std::runtime_error(fmt::format(
          "what the page shows of this drive takes more than {} MB; look at the bag itself: bandwagon view BAG",
          kLargestPageBag >> 20U));
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  void sync() override {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] bag::Bytes take() { return std::exchange(bytes_, {}); }

 private:
  bag::Bytes bytes_;
};

/// Leg detections are many, and nobody looks at them on the page.
bool is_shown(const bag::BagTopic& topic) {
  return std::ranges::find(kShown, topic.type) != kShown.end() && !topic.name.ends_with("leg_detections");
}

bag::mcap::Schema schema_of(const bag::BagTopic& topic, std::uint16_t id) {
  std::string encoding = topic.schema_encoding;
  std::string text = topic.schema_text;
  if (text.empty()) {  // older SQLite bags tell names of types only
    if (const TypeDescription* type = bag::known_type(topic).type; type != nullptr) {
      encoding = "ros2msg";
      text = bag::schema_text(*type);
    }
  }
  return {.id = id, .name = topic.type, .encoding = encoding, .data = {text.begin(), text.end()}};
}

}  // namespace

bag::Bytes shown_bag(const bag::Bag& bag) {
  const auto sink = std::make_shared<MemorySink>();
  bag::mcap::Writer writer(sink, {});
  bag::BagSelection selection;
  selection.topics.emplace();
  const std::vector<bag::BagTopic>& topics = bag.topics();
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if (!is_shown(topics[i])) continue;
    const auto id = static_cast<std::uint16_t>(i + 1);
    selection.topics->insert(topics[i].name);
    writer.add_schema(schema_of(topics[i], id));
    writer.add_channel({.id = id,
                        .schema_id = id,
                        .topic = topics[i].name,
                        .message_encoding = topics[i].serialization_format,
                        .metadata = {{"offered_qos_profiles", topics[i].offered_qos_profiles}}});
  }
  for (const auto& [name, entries] : bag.metadata())
    if (name == "bandwagon" || name == "result") writer.write(bag::mcap::Metadata{name, entries});
  const auto messages = bag.messages(selection);
  bag::BagMessage m;
  for (bag::Step step = messages->next(m); step != bag::Step::end; step = messages->next(m)) {
    if (step == bag::Step::damaged || !is_shown(topics[m.topic])) continue;
    writer.write(bag::mcap::Message{.channel_id = static_cast<std::uint16_t>(m.topic + 1),
                                    .log_time = static_cast<std::uint64_t>(m.log_time.nanoseconds),
                                    .publish_time = static_cast<std::uint64_t>(m.publish_time.nanoseconds),
                                    .data = m.data});
  }
  writer.close();
  return sink->take();
}

}  // namespace bw
