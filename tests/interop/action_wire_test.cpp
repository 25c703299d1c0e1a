// Our action servers as another program sees them on the wire, in the layouts of Humble and of Jazzy:
// plain::Node follows rmw_fastrtps and rcl_action by the letter and shares no code with this project.
#include <algorithm>

#include <gmock/gmock.h>

#include "tests/interop/action_ends.hpp"
#include "tests/interop/action_process.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/on_the_wire.hpp"
#include "tests/interop/plain/action_server.hpp"

namespace bw::test {
namespace {

using plain::CancelCode;
using plain::goal_id;
using plain::GoalStatus;
using plain::to_hex;
using testing::AnyOf;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

using Distros = testing::Types<Humble, Jazzy>;

/// The codes of scripted_actions.hpp.
constexpr std::uint16_t kToldToAbort = 42, kPreempted = 43;

/// Ids of goals differ from test to test: the server remembers.
std::uint32_t next_goal() {
  static std::uint32_t count = 0;
  return ++count;
}

template <class Distro>
class ActionServerOnTheWire : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    server_ = std::make_unique<ActionProcess>(std::vector<std::string>{"serve", Distro::kName});
  }
  static void TearDownTestSuite() {
    EXPECT_EQ(server_->stop(), 0) << server_->process().err();
    server_.reset();
  }
  ActionServerOnTheWire() : wire_(std::make_shared<plain::Wire>()), node_("plain", wire_, Distro::kGidSize) {}

  plain::GoalId new_goal() const { return goal_id(next_goal()); }
  /// Sent and accepted.
  plain::GoalInfo start(plain::ActionClient& client, const std::string& text) {
    const plain::GoalId id = new_goal();
    const auto answer = client.send(id, navigate_goal(text));
    if (!answer) throw std::runtime_error("no answer: " + server_->process().err());
    EXPECT_TRUE(answer->is_accepted) << text;
    return {.id = id, .stamp = answer->stamp};
  }
  /// The end of a goal, as its result tells.
  void expect_result(plain::ActionClient& client, const plain::GoalInfo& goal, GoalStatus status,
                     std::uint16_t code = 0, const std::string& text = "") {
    const auto result = client.result(goal.id);
    ASSERT_TRUE(result.has_value()) << server_->process().err();
    EXPECT_EQ(to_hex(result->bytes), result_hex<Distro>(status, code, text));
  }
  /// Answered in the order of asking: a reply that was not there before this is none.
  void expect_answered(plain::ActionClient& client) {
    const auto result = client.result(goal_id(0xffffffff));
    ASSERT_TRUE(result.has_value());
    EXPECT_EQ(result->status, GoalStatus::unknown);
  }

  static std::unique_ptr<ActionProcess> server_;
  std::shared_ptr<plain::Wire> wire_;
  plain::Node node_;
};

template <class Distro>
std::unique_ptr<ActionProcess> ActionServerOnTheWire<Distro>::server_;

TYPED_TEST_SUITE(ActionServerOnTheWire, Distros);

TYPED_TEST(ActionServerOnTheWire, EndsHaveTheNamesTypesQosAndHashesOfRos2AndTheNodeListsThem) {
  const auto expected = ends_of_server("/together", TypeParam::navigate_to_pose());
  std::set<plain::Gid> readers, writers;
  for (const ExpectedEnd& wanted : expected) {
    ASSERT_TRUE(eventually([&] { return this->node_.count(wanted.topic, wanted.is_writer) == 1; }))
        << wanted.topic;
    const auto [gid, end] = foreign_end(this->node_, wanted.topic, wanted.is_writer);
    EXPECT_EQ(end.type, wanted.type);
    if (!wanted.hash.empty()) {
      EXPECT_EQ(end.user_data, "typehash=" + wanted.hash + ";") << wanted.topic;
    }
    EXPECT_TRUE(end.is_reliable) << wanted.topic;
    EXPECT_EQ(end.is_volatile, !wanted.is_latched) << wanted.topic;
    (wanted.is_writer ? writers : readers).insert(gid);
  }
  const auto lists_all = [&](const plain::NodeInfo& info) {
    return info.name == "/server" && std::ranges::includes(info.readers, readers) &&
           std::ranges::includes(info.writers, writers);
  };
  EXPECT_TRUE(eventually([&] { return std::ranges::any_of(this->node_.nodes(), lists_all); }));
}

TYPED_TEST(ActionServerOnTheWire, AGoalGoesItsWayAndItsResultIsToldBeforeAndAfterItsEnd) {
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  ASSERT_TRUE(client.wait_until_ready());
  const plain::GoalInfo goal = this->start(client, "steps 3");
  EXPECT_GT(goal.stamp.sec, 0);
  const std::int64_t early = client.ask_result(goal.id);
  std::optional<plain::Result> result;
  ASSERT_TRUE(eventually([&] { return (result = client.take_result(early)).has_value(); }));
  EXPECT_EQ(to_hex(result->bytes), result_hex<TypeParam>(GoalStatus::succeeded));
  this->expect_result(client, goal, GoalStatus::succeeded);
  this->expect_result(client, goal, GoalStatus::succeeded);
  // Feedback 2, 1, 0: zeros but for the distance at its end, behind int16 recoveries.
  std::vector<float> left;
  for (const plain::Feedback& feedback : client.feedback()) {
    EXPECT_EQ(feedback.id, goal.id);
    plain::CdrIn cdr = feedback.fields;
    cdr.number<std::int32_t>();
    cdr.number<std::uint32_t>();
    cdr.text();
    for (int i = 0; i < 7; ++i) cdr.number<double>();
    for (int i = 0; i < 4; ++i) cdr.number<std::int32_t>();  // two durations
    cdr.number<std::int16_t>();
    left.push_back(cdr.number<float>());
  }
  EXPECT_THAT(left, ElementsAre(2.0F, 1.0F, 0.0F));
  ASSERT_TRUE(eventually([&] {
    const auto history = client.history(goal.id);
    return !history.empty() && history.back() == GoalStatus::succeeded;
  }));
  EXPECT_THAT(client.history(goal.id),
              AnyOf(ElementsAre(GoalStatus::accepted, GoalStatus::executing, GoalStatus::succeeded),
                    ElementsAre(GoalStatus::executing, GoalStatus::succeeded)))
      << "a latched topic keeps one sample";
}

TYPED_TEST(ActionServerOnTheWire, RepliesAreForTheReaderThatAskedAndTheCountOfItsRequest) {
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  ASSERT_TRUE(client.wait_until_ready());
  const plain::GoalInfo goal = this->start(client, "steps 2");
  this->expect_result(client, goal, GoalStatus::succeeded);  // deferred
  for (plain::Client* service : {&client.goal_service(), &client.result_service()}) {
    const std::string name = service == &client.goal_service() ? "send_goal" : "get_result";
    const plain::Gid writer = foreign_end(this->node_, "rr/together/_action/" + name + "Reply", true).first;
    const auto replies = this->wire_->data_of(writer);
    ASSERT_FALSE(replies.empty());
    ASSERT_TRUE(replies[0].inline_qos.contains(kRelatedIdentity));
    EXPECT_EQ(to_hex(replies[0].inline_qos.at(kRelatedIdentity)),
              to_hex(identity_bytes(plain::to_gid(service->reader().guid()), 0, 1)))
        << name;
  }
}

TYPED_TEST(ActionServerOnTheWire, AnAbortedGoalTellsItsCode) {
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  this->expect_result(client, this->start(client, "abort"), GoalStatus::aborted, kToldToAbort, "told to");
}

TYPED_TEST(ActionServerOnTheWire, TheResultOfAnUnknownGoalIsStatusZeroAndNothingElse) {
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  this->expect_result(client, {.id = this->new_goal()}, GoalStatus::unknown);
}

TYPED_TEST(ActionServerOnTheWire, AnIdIsAcceptedOnce) {
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  const plain::GoalInfo goal = this->start(client, "hold");
  auto again = client.send(goal.id, navigate_goal("succeed"));
  ASSERT_TRUE(again.has_value());
  EXPECT_FALSE(again->is_accepted) << "it is open";
  ASSERT_TRUE(client.cancel({.id = goal.id}).has_value());
  this->expect_result(client, goal, GoalStatus::canceled);
  again = client.send(goal.id, navigate_goal("succeed"));
  ASSERT_TRUE(again.has_value());
  EXPECT_FALSE(again->is_accepted) << "its result is kept";
  this->expect_result(client, goal, GoalStatus::canceled);
}

TYPED_TEST(ActionServerOnTheWire, CancelOfOneGoalAnswersAsRclDoes) {
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  const auto cancel = [&](const plain::GoalInfo& which) {
    const auto reply = client.cancel(which);
    if (!reply) throw std::runtime_error("no answer to a cancel");
    return *reply;
  };
  const plain::GoalInfo slow = this->start(client, "slow 1000");
  const plain::GoalInfo other = this->start(client, "hold");
  const plain::CancelReply first = cancel({.id = slow.id});
  EXPECT_EQ(first.code, CancelCode::none);
  EXPECT_THAT(first.canceling, ElementsAre(slow));
  const plain::CancelReply again = cancel({.id = slow.id});
  EXPECT_EQ(again.code, CancelCode::goal_terminated) << "while it is being canceled or when it is";
  EXPECT_THAT(again.canceling, IsEmpty());
  this->expect_result(client, slow, GoalStatus::canceled);
  EXPECT_EQ(cancel({.id = slow.id}).code, CancelCode::goal_terminated);
  EXPECT_EQ(cancel({.id = this->new_goal()}).code, CancelCode::unknown_goal_id);
  EXPECT_THAT(client.history(slow.id), testing::IsSupersetOf({GoalStatus::canceling, GoalStatus::canceled}));
  EXPECT_EQ(client.history(other.id).back(), GoalStatus::executing);
  EXPECT_EQ(cancel({.id = other.id}).code, CancelCode::none);
  this->expect_result(client, other, GoalStatus::canceled);
}

TYPED_TEST(ActionServerOnTheWire, CancelOfAllNamesEachThatIsOpen) {
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  const plain::GoalInfo waiting = this->start(client, "wait"), holding = this->start(client, "hold"),
                        deaf = this->start(client, "deaf 20");
  auto reply = client.cancel({});
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->code, CancelCode::none);
  EXPECT_THAT(reply->canceling, testing::UnorderedElementsAre(waiting, holding, deaf));
  this->expect_result(client, waiting, GoalStatus::canceled);
  this->expect_result(client, holding, GoalStatus::canceled);
  this->expect_result(client, deaf, GoalStatus::succeeded);
  reply = client.cancel({});
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->code, CancelCode::none) << "none is open: no error, as in rcl";
  EXPECT_THAT(reply->canceling, IsEmpty());
}

TYPED_TEST(ActionServerOnTheWire, CancelUpToAStampLeavesLaterGoals) {
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  const plain::GoalInfo first = this->start(client, "hold"), second = this->start(client, "hold"),
                        third = this->start(client, "hold"), fourth = this->start(client, "hold");
  ASSERT_LT(second.stamp, third.stamp);
  auto reply = client.cancel({.id = {}, .stamp = second.stamp});
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->code, CancelCode::none);
  EXPECT_THAT(reply->canceling, testing::UnorderedElementsAre(first, second));
  // An id beside a stamp: that goal too. An unknown one is no error then.
  reply = client.cancel({.id = fourth.id, .stamp = second.stamp});
  ASSERT_TRUE(reply.has_value());
  EXPECT_THAT(reply->canceling, ElementsAre(fourth));
  reply = client.cancel({.id = this->new_goal(), .stamp = second.stamp});
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->code, CancelCode::none);
  EXPECT_THAT(reply->canceling, IsEmpty());
  reply = client.cancel({});
  ASSERT_TRUE(reply.has_value());
  EXPECT_THAT(reply->canceling, ElementsAre(third));
  for (const plain::GoalInfo& goal : {first, second, third, fourth})
    this->expect_result(client, goal, GoalStatus::canceled);
}

TYPED_TEST(ActionServerOnTheWire, APreemptedGoalIsAbortedAndItsWaitingClientIsTold) {
  plain::ActionClient client(this->node_, "/preempting", TypeParam::navigate_to_pose());
  ASSERT_TRUE(client.wait_until_ready());
  const plain::GoalInfo first = this->start(client, "hold");
  const std::int64_t waiting = client.ask_result(first.id);
  const plain::GoalInfo second = this->start(client, "hold");
  std::optional<plain::Result> result;
  ASSERT_TRUE(eventually([&] { return (result = client.take_result(waiting)).has_value(); }));
  EXPECT_EQ(to_hex(result->bytes),
            result_hex<TypeParam>(GoalStatus::aborted, kPreempted, "another goal came"));
  EXPECT_TRUE(eventually([&] { return client.history(second.id).back() == GoalStatus::executing; }));
  ASSERT_TRUE(client.cancel({.id = second.id}).has_value());
  this->expect_result(client, second, GoalStatus::canceled);
}

TYPED_TEST(ActionServerOnTheWire, WhoComesLateHearsTheNewestStatusListAndNoOther) {
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  const plain::GoalInfo done = this->start(client, "succeed"), open = this->start(client, "hold");
  this->expect_result(client, done, GoalStatus::succeeded);
  ASSERT_TRUE(eventually([&] {
    const auto history = client.history(open.id);
    return !history.empty() && history.back() == GoalStatus::executing;
  }));
  plain::Node late_node("late", nullptr, TypeParam::kGidSize);
  plain::ActionClient late(late_node, "/together", TypeParam::navigate_to_pose());
  ASSERT_TRUE(eventually([&] { return !late.status_lists().empty(); }));
  EXPECT_THAT(late.status_lists(), SizeIs(1)) << "depth 1";
  EXPECT_THAT(late.history(done.id), ElementsAre(GoalStatus::succeeded));
  EXPECT_THAT(late.history(open.id), ElementsAre(GoalStatus::executing));
  ASSERT_TRUE(client.cancel({.id = open.id}).has_value());
  this->expect_result(client, open, GoalStatus::canceled);
}

/// On the time of /clock, which this test gives.
template <class Distro>
class KeptResults : public testing::Test {
 protected:
  KeptResults() : server_({"serve", Distro::kName, "topic"}), node_("plain", nullptr, Distro::kGidSize) {
    clock_ = node_.create_writer(
        {.topic = "rt/clock", .type = "rosgraph_msgs::msg::dds_::Clock_", .type_hash = {}, .depth = 1});
    node_.announce();
  }
  ~KeptResults() override { EXPECT_EQ(server_.stop(), 0) << server_.process().err(); }

  void set_clock(std::int32_t sec) {
    plain::Bytes bytes = plain::CdrOut().number(sec).number(std::uint32_t{0}).bytes();
    clock_->write(&bytes);
  }
  /// Whether the goal is known, once the server has seen the time: what a goal sent afterwards is stamped
  /// with.
  GoalStatus status_at(plain::ActionClient& client, const plain::GoalId& id, std::int32_t sec) {
    EXPECT_TRUE(eventually([&] {
      set_clock(sec);
      const auto probe = client.send(goal_id(next_goal()), navigate_goal("succeed"));
      return probe && probe->stamp.sec == sec;
    }));
    const auto result = client.result(id);
    if (!result) throw std::runtime_error("no result: " + server_.process().err());
    return result->status;
  }

  ActionProcess server_;
  plain::Node node_;
  plain::dds::DataWriter* clock_ = nullptr;
};

TYPED_TEST_SUITE(KeptResults, Distros);

TYPED_TEST(KeptResults, FifteenMinutesInHumbleAndTenSecondsInJazzy) {
  constexpr std::int32_t kStart = 1000;
  const std::int32_t kept = std::is_same_v<TypeParam, Humble> ? 15 * 60 : 10;
  plain::ActionClient client(this->node_, "/together", TypeParam::navigate_to_pose());
  const plain::GoalId done = goal_id(next_goal()), open = goal_id(next_goal());
  ASSERT_TRUE(eventually([&] {
    this->set_clock(kStart);
    return client.is_ready();
  }));
  EXPECT_EQ(this->status_at(client, goal_id(0xfffffffe), kStart), GoalStatus::unknown);
  ASSERT_TRUE(client.send(open, navigate_goal("hold")).value().is_accepted);
  ASSERT_TRUE(client.send(done, navigate_goal("succeed")).value().is_accepted);
  EXPECT_EQ(this->status_at(client, done, kStart), GoalStatus::succeeded);
  EXPECT_EQ(this->status_at(client, done, kStart + kept), GoalStatus::succeeded);
  EXPECT_EQ(this->status_at(client, done, kStart + kept + 1), GoalStatus::unknown);
  EXPECT_EQ(client.cancel({.id = done}).value().code, CancelCode::unknown_goal_id) << "forgotten altogether";
  EXPECT_EQ(client.cancel({.id = open}).value().code, CancelCode::none) << "open goals are never forgotten";
}

}  // namespace
}  // namespace bw::test
