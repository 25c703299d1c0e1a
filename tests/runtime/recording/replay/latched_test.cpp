// What a late reader would know. Expected messages are those written, by hand.
#include "runtime/recording/replay/latched.hpp"

#include <functional>

#include <gmock/gmock.h>
#include <std_msgs/msg/string.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <unistd.h>

#include "runtime/recording/bag/bag_writer.hpp"
#include "runtime/recording/bag/qos_text.hpp"
#include "runtime/wire/serialization.hpp"
#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::replay {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

bag::Bytes text(const std::string& data) {
  std_msgs::msg::String message;
  message.data(data);
  bag::Bytes cdr;
  serialize(message, cdr);
  return cdr;
}

bag::Bytes transforms(const std::vector<std::string>& frames, double x) {
  tf2_msgs::msg::TFMessage message;
  for (const std::string& frame : frames) {
    geometry_msgs::msg::TransformStamped transform;
    transform.child_frame_id(frame);
    transform.transform().translation().x(x);
    message.transforms().push_back(transform);
  }
  bag::Bytes cdr;
  serialize(message, cdr);
  return cdr;
}

bag::BagTopic topic(const std::string& name, const std::string& type, const Qos& qos,
                    const std::string& writer = "") {
  return {.name = name, .type = type, .writer = writer, .offered_qos_profiles = bag::to_qos_text({qos})};
}

/// What is latched at `time` in the bag that `fill` writes.
std::vector<bag::Bytes> latched(Time time, const std::function<void(bag::BagWriter&)>& fill) {
  const bag::mcap::Folder folder;
  bag::BagWriter writer(folder / "a.mcap", {});
  fill(writer);
  writer.close();
  const auto recording = bag::open_bag(folder / "a.mcap");
  std::vector<bag::Bytes> out;
  for (LatchedMessage& message : latched_before(*recording, time, played_topics(recording->topics(), {})))
    out.push_back(std::move(message.cdr));
  return out;
}

TEST(Latched, IsTheLastMessageOfEachLatchedWriter) {
  const auto found = latched({50}, [](bag::BagWriter& writer) {
    const auto map = writer.add_topic(topic("/map", "std_msgs/msg/String", Qos::latched(), "one"));
    const auto other = writer.add_topic(topic("/map", "std_msgs/msg/String", Qos::latched(), "two"));
    const auto loose = writer.add_topic(topic("/loose", "std_msgs/msg/String", Qos::standard()));
    writer.write(map, {10}, {10}, text("old"));
    writer.write(other, {20}, {20}, text("of two"));
    writer.write(map, {30}, {30}, text("new"));
    writer.write(loose, {40}, {40}, text("not latched"));
    writer.write(map, {50}, {50}, text("not before the time"));
  });
  EXPECT_THAT(found, ElementsAre(text("of two"), text("new")));
}

TEST(Latched, OfTfStaticEveryTransformThatNoLaterMessageTells) {
  const auto found = latched({50}, [](bag::BagWriter& writer) {
    const auto tf = writer.add_topic(topic("/tf_static", "tf2_msgs/msg/TFMessage", Qos::latched()));
    writer.write(tf, {10}, {10}, transforms({"laser"}, 1.0));
    writer.write(tf, {20}, {20}, transforms({"imu", "gps"}, 1.0));
    writer.write(tf, {30}, {30}, transforms({"laser"}, 2.0));
    writer.write(tf, {40}, {40}, transforms({"imu"}, 2.0));
  });
  EXPECT_THAT(found, ElementsAre(transforms({"imu", "gps"}, 1.0), transforms({"laser"}, 2.0),
                                 transforms({"imu"}, 2.0)));
}

TEST(Latched, ABroadcasterThatRepeatsItselfTakesNoMemory) {
  const auto found = latched({10'000}, [](bag::BagWriter& writer) {
    const auto tf = writer.add_topic(topic("/tf_static", "tf2_msgs/msg/TFMessage", Qos::latched()));
    for (std::int64_t i = 0; i < 5000; ++i)
      writer.write(tf, {i}, {i}, transforms({"laser"}, static_cast<double>(i)));
  });
  EXPECT_THAT(found, ElementsAre(transforms({"laser"}, 4999.0)));
}

TEST(Latched, WhatHasOutlivedItsLifespanIsGone) {
  // /rosout is latched for 10 s.
  const auto fill = [](bag::BagWriter& writer) {
    writer.write(writer.add_topic(topic("/rosout", "std_msgs/msg/String", Qos::rosout())), {0}, {0},
                 text("hello"));
  };
  EXPECT_THAT(latched({9'000'000'000}, fill), ElementsAre(text("hello")));
  EXPECT_THAT(latched({11'000'000'000}, fill), IsEmpty());
}

}  // namespace
}  // namespace bw::replay
