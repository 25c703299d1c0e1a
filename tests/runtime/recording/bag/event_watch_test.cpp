// When a message is an event. Conditions hold or do not by the values written into the messages.
#include "runtime/recording/bag/event_watch.hpp"

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <gmock/gmock.h>
#include <nav2_msgs/msg/collision_monitor_state.hpp>

#include "runtime/wire/serialization.hpp"
#include "runtime/wire/type_registry.hpp"
#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::bag {
namespace {

using diagnostic_msgs::msg::DiagnosticArray;
using ::testing::HasSubstr;

template <class M>
std::vector<std::uint8_t> bytes_of(const M& message) {
  std::vector<std::uint8_t> cdr;
  serialize(message, cdr);
  return cdr;
}

const TypeDescription& type(const char* name) { return *find_type(name); }

/// For each message: whether it is the event.
template <class M>
std::vector<bool> events(const std::vector<EventCondition>& when, const std::vector<M>& messages) {
  EventWatch watch({Event{"event", "/topic", when}});
  const std::size_t other = watch.add_topic("/other", find_type(MessageTraits<M>::ros_name));
  const std::size_t topic = watch.add_topic("/topic", find_type(MessageTraits<M>::ros_name));
  EXPECT_FALSE(watch.is_watched(other));
  std::vector<bool> happened;
  for (const M& message : messages) happened.push_back(!watch.look(topic, bytes_of(message)).empty());
  return happened;
}

nav2_msgs::msg::CollisionMonitorState state(std::uint8_t action, const std::string& cause) {
  nav2_msgs::msg::CollisionMonitorState message;
  message.action_type(action);
  message.polygon_name(cause);
  return message;
}

bandwagon_msgs::msg::GroundTruth truth(std::uint32_t contacts) {
  bandwagon_msgs::msg::GroundTruth message;
  message.contacts(contacts);
  return message;
}

/// Components and what they say.
DiagnosticArray diagnostics(const std::vector<std::pair<std::string, std::string>>& statuses) {
  DiagnosticArray message;
  for (const auto& [name, text] : statuses) {
    diagnostic_msgs::msg::DiagnosticStatus status;
    status.name(name);
    status.message(text);
    message.status().push_back(status);
  }
  return message;
}

TEST(EventWatch, WithoutConditionsEveryMessageIsOne) {
  EXPECT_EQ(events({}, std::vector{state(0, ""), state(0, "")}), (std::vector{true, true}));
}

TEST(EventWatch, AllConditionsMustBeginToHold) {
  const std::vector<EventCondition> stop = {
      {.field = "action_type", .rule = EventRule::is, .number = 1.0},
      {.field = "polygon_name", .rule = EventRule::is_not, .text = "command_silent"}};
  EXPECT_EQ(events(stop, std::vector{state(0, ""), state(1, "command_silent"), state(1, "laser"),
                                     state(1, "laser"), state(2, "laser"), state(1, "laser")}),
            (std::vector{false, false, true, false, false, true}));
}

TEST(EventWatch, ACounterRises) {
  const std::vector<EventCondition> contact = {{.field = "contacts", .rule = EventRule::rises}};
  // What was there before the first message is nobody's event; each rise is one, a counter that begins again
  // is none.
  EXPECT_EQ(
      events(contact, std::vector{truth(2), truth(2), truth(3), truth(5), truth(5), truth(0), truth(1)}),
      (std::vector{false, false, true, true, false, false, true}));
}

TEST(EventWatch, ConditionsOnAListMeetInOneElement) {
  const std::vector<EventCondition> lost = {
      {.field = "status[].name", .rule = EventRule::is, .text = "localization"},
      {.field = "status[].message", .rule = EventRule::begins_with, .text = "LOST"}};
  EXPECT_EQ(
      events(lost, std::vector{diagnostics({{"localization", "OK"}, {"other", "LOST"}}), diagnostics({}),
                               diagnostics({{"other", "OK"}, {"localization", "LOST: wheels"}})}),
      (std::vector{false, false, true}));
}

TEST(EventWatch, NumbersAreComparedAsNumbers) {
  const std::vector<EventCondition> above = {
      {.field = "wall_clearance", .rule = EventRule::above, .number = 0.5}};
  const std::vector<EventCondition> below = {
      {.field = "wall_clearance", .rule = EventRule::below, .number = 0.5}};
  std::vector<bandwagon_msgs::msg::GroundTruth> drive(3);
  drive[0].wall_clearance(0.5);
  drive[1].wall_clearance(0.7);
  drive[2].wall_clearance(0.2);
  EXPECT_EQ(events(above, drive), (std::vector{false, true, false}));
  EXPECT_EQ(events(below, drive), (std::vector{false, false, true}));
}

TEST(EventWatch, BytesThatAreNoMessageAreNoEvent) {
  EventWatch watch(
      {Event{"contact", "/topic", {{.field = "contacts", .rule = EventRule::is, .number = 0.0}}}});
  const std::size_t topic = watch.add_topic("/topic", &type("bandwagon_msgs/msg/GroundTruth"));
  std::vector<std::uint8_t> cdr = bytes_of(truth(0));
  cdr.resize(cdr.size() / 2);
  EXPECT_TRUE(watch.look(topic, cdr).empty());
}

TEST(ConditionRule, RefusesInWordsWhatCannotBeLookedAt) {
  const auto rule = [](const char* message, EventCondition condition) {
    return condition_rule(type(message), condition).value_or("fine");
  };
  const char* array = "diagnostic_msgs/msg/DiagnosticArray";
  const char* ground_truth = "bandwagon_msgs/msg/GroundTruth";
  EXPECT_EQ(rule(array, {.field = "status[].values[3].key", .text = "x"}), "fine");
  EXPECT_EQ(rule(ground_truth, {.field = "pose.position.x", .rule = EventRule::above, .number = 1.0}),
            "fine");
  EXPECT_THAT(rule(ground_truth, {.field = "contact", .rule = EventRule::rises}),
              HasSubstr("did you mean 'contacts'"));
  EXPECT_THAT(rule(ground_truth, {.field = "pose.positon.x"}), HasSubstr("did you mean 'position'"));
  EXPECT_THAT(rule(ground_truth, {.field = "pose"}), HasSubstr("is a message: name a field of it"));
  EXPECT_THAT(rule(ground_truth, {.field = "contacts.x"}), HasSubstr("has no fields"));
  EXPECT_THAT(rule(ground_truth, {.field = "contacts[]"}), HasSubstr("is one value"));
  EXPECT_THAT(rule(array, {.field = "status.name"}), HasSubstr("is a sequence"));
  EXPECT_THAT(rule(array, {.field = "status[].values[].key", .text = "x"}), HasSubstr("once only"));
  EXPECT_THAT(rule(array, {.field = "status[].level", .rule = EventRule::rises}), HasSubstr("of one value"));
  EXPECT_THAT(rule(ground_truth, {.field = "contacts", .text = "two"}), HasSubstr("is a number"));
  EXPECT_THAT(rule(ground_truth, {.field = "contacts", .rule = EventRule::begins_with, .text = "2"}),
              HasSubstr("is no text"));
  EXPECT_THAT(rule(array, {.field = "header.frame_id", .rule = EventRule::above, .number = 1.0}),
              HasSubstr("is no number"));
}

}  // namespace
}  // namespace bw::bag
