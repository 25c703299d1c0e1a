// What strangers do to our action servers: requests that are none, layouts of another distribution, floods of
// goals, ids twice, clients that die, goals for who is not active. Each goal that was accepted ends once, and
// the server takes the next client's as if nothing had been. The client shares no code with this project
// (plain::Node).
#include <algorithm>
#include <functional>
#include <map>

#include <gmock/gmock.h>

#include "tests/interop/action_process.hpp"
#include "tests/interop/eventually.hpp"

namespace bw::test {
namespace {

using plain::CancelCode;
using plain::from_hex;
using plain::goal_id;
using plain::GoalStatus;
using plain::to_hex;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The codes of scripted_actions.hpp.
constexpr std::uint16_t kPreempted = 43, kAbandoned = 44;

bool is_final(GoalStatus status) { return status >= GoalStatus::succeeded; }

class ActionFaults : public testing::Test {
 protected:
  explicit ActionFaults(const std::string& distro = "jazzy")
      : server_({"serve", distro}), node_("stranger") {}
  ~ActionFaults() override {
    expect_alive();
    EXPECT_EQ(server_.stop(), 0) << err();
  }

  static plain::ActionType navigate() { return Jazzy::navigate_to_pose(); }
  static plain::ActionType follow() { return plain::action_type(kFollowPath); }
  plain::GoalId next_id() { return goal_id(++count_); }
  std::string err() { return server_.process().err(); }

  /// A newcomer's goal on each action, from its request to its result. Nothing of before is open on
  /// /preempting and /follow after it.
  void expect_alive() {
    plain::Node newcomer("newcomer");
    const auto drive = [&](const std::string& action, const plain::ActionType& type,
                           const plain::Bytes& goal) {
      plain::ActionClient client(newcomer, action, type);
      const plain::GoalId id = next_id();
      ASSERT_TRUE(client.wait_until_ready()) << action << err();
      const auto answer = client.send(id, goal);
      ASSERT_TRUE(answer && answer->is_accepted) << action << err();
      const auto result = client.result(id);
      ASSERT_TRUE(result.has_value()) << action << err();
      EXPECT_EQ(result->status, GoalStatus::succeeded) << action;
    };
    drive("/together", navigate(), navigate_goal("steps 1"));
    drive("/preempting", navigate(), navigate_goal("steps 1"));
    drive("/follow", follow(), follow_goal("steps 1", 2, 2));
  }
  /// Statuses never go back, and what is final stays.
  static void expect_forward(const std::vector<GoalStatus>& history) {
    for (std::size_t i = 1; i < history.size(); ++i) {
      EXPECT_GT(history[i], history[i - 1]);
      EXPECT_FALSE(is_final(history[i - 1]));
    }
  }

  ActionProcess server_;
  plain::Node node_;
  std::uint32_t count_ = 0;
};

class ActionFaultsInHumble : public ActionFaults {
 protected:
  ActionFaultsInHumble() : ActionFaults("humble"), humble_("stranger", nullptr, plain::GidSize::humble) {}
  plain::Node humble_;
};

TEST_F(ActionFaults, RequestsCutAnywhereAreRefusedOrIgnored) {
  plain::ActionClient client(node_, "/together", navigate());
  ASSERT_TRUE(client.wait_until_ready());
  const plain::Bytes whole = plain::with_goal_id(next_id(), navigate_goal("succeed"));
  // A sample is padded to a multiple of 4: the last cut ones would be whole again.
  for (std::size_t size = 0; size <= whole.size() - 4; ++size) {
    const std::int64_t asked =
        client.goal_service().send({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
    if (size % 16 != 0) continue;  // a queue holds 1,000 of them, this waits now and then
    ASSERT_TRUE(client.result(goal_id(0xffffffff)).has_value()) << "after " << size << " bytes: " << err();
    const auto answer = client.take_goal(asked);
    EXPECT_FALSE(answer && answer->is_accepted) << size << " bytes";
  }
  for (const char* hex : {"", "00010000", "00010000 b0000000 00000000 00000000"}) {
    client.cancel_service().send(from_hex(hex));
    client.result_service().send(from_hex(hex));
  }
  ASSERT_TRUE(client.result(goal_id(0xffffffff)).has_value()) << err();
  for (const auto& list : client.status_lists()) EXPECT_THAT(list, IsEmpty());
  EXPECT_THAT(err(), HasSubstr("a request of /together/_action/send_goal holds no "));
}

TEST_F(ActionFaults, HumblesFollowPathIsNoJazzys) {
  // Without the text of the progress checker the request ends early.
  plain::ActionClient client(node_, "/follow", follow());
  ASSERT_TRUE(client.wait_until_ready());
  const auto answer = client.send(next_id(), follow_goal("succeed", 3, 1));
  ASSERT_TRUE(answer.has_value()) << err();
  EXPECT_FALSE(answer->is_accepted);
  EXPECT_THAT(client.status_lists(), testing::Each(IsEmpty()));
}

TEST_F(ActionFaultsInHumble, JazzysFollowPathHasBytesTooManyAndIsTakenForWhatItBeginsWith) {
  // Trailing bytes are padding to every reader of CDR: the goal is Humble's, and ends.
  plain::ActionClient client(humble_, "/follow", follow());
  ASSERT_TRUE(client.wait_until_ready());
  const plain::GoalId id = next_id();
  const auto answer = client.send(id, follow_goal("succeed", 3, 2));
  ASSERT_TRUE(answer.has_value()) << err();
  ASSERT_TRUE(answer->is_accepted);
  const auto result = client.result(id);
  ASSERT_TRUE(result.has_value()) << err();
  EXPECT_EQ(to_hex(result->bytes), result_hex<Humble>(GoalStatus::succeeded));
}

TEST_F(ActionFaults, HundredThousandPosesAreReadAndMoreThanTheyAreIsNot) {
  plain::ActionClient client(node_, "/follow", follow());
  ASSERT_TRUE(client.wait_until_ready());
  const plain::GoalId id = next_id();
  const auto answer = client.send(id, follow_goal("succeed", 100'000, 2));
  ASSERT_TRUE(answer.has_value()) << err();
  EXPECT_TRUE(answer->is_accepted);
  const auto result = client.result(id);
  ASSERT_TRUE(result.has_value()) << err();
  EXPECT_EQ(result->status, GoalStatus::succeeded);
  // The count says four milliards; there are two.
  plain::Bytes lying = plain::with_goal_id(next_id(), follow_goal("succeed", 2, 2));
  constexpr std::size_t kCountAt = plain::kEncapsulation + 16 + 8 + 8;
  std::fill_n(lying.begin() + kCountAt, 4, 0xff);
  const std::int64_t asked = client.goal_service().send(lying);
  ASSERT_TRUE(client.result(goal_id(0xffffffff)).has_value()) << err();
  const auto reply = client.take_goal(asked);
  EXPECT_FALSE(reply && reply->is_accepted);
}

TEST_F(ActionFaults, FiftyGoalsAtOnceEachEndOnceAndTheLastDrives) {
  constexpr int kGoals = 50;
  plain::ActionClient client(node_, "/preempting", navigate());
  ASSERT_TRUE(client.wait_until_ready());
  std::map<std::int64_t, plain::GoalId> asked;
  std::vector<plain::GoalId> ids;
  for (int i = 0; i < kGoals; ++i) {
    ids.push_back(next_id());
    asked[client.ask_goal(ids.back(), navigate_goal("hold"))] = ids.back();
  }
  ASSERT_TRUE(eventually([&] {
    std::erase_if(asked, [&](const auto& item) {
      const auto answer = client.take_goal(item.first);
      EXPECT_TRUE(!answer || answer->is_accepted);
      return answer.has_value();
    });
    return asked.empty();
  })) << asked.size()
      << " unanswered" << err();
  for (int i = 0; i + 1 < kGoals; ++i) {
    const auto result = client.result(ids[static_cast<std::size_t>(i)]);
    ASSERT_TRUE(result.has_value()) << i;
    EXPECT_EQ(to_hex(result->bytes), result_hex<Jazzy>(GoalStatus::aborted, kPreempted, "another goal came"));
  }
  const auto canceled = client.cancel({.id = ids.back()});
  ASSERT_TRUE(canceled.has_value());
  EXPECT_EQ(canceled->code, CancelCode::none) << "the last one goes on";
  EXPECT_EQ(client.result(ids.back()).value().status, GoalStatus::canceled);
  for (const plain::GoalId& id : ids) expect_forward(client.history(id));
}

TEST_F(ActionFaults, AThousandOpenGoalsAreTheMost) {
  constexpr int kMax = 1000, kMore = 20;
  plain::ActionClient client(node_, "/together", navigate());
  ASSERT_TRUE(client.wait_until_ready());
  int accepted = 0, answered = 0;
  std::vector<std::int64_t> asked;
  for (int i = 0; i < kMax + kMore; ++i) {
    asked.push_back(client.ask_goal(next_id(), navigate_goal("wait")));
    if (i % 50 != 49 && i + 1 < kMax + kMore) continue;
    ASSERT_TRUE(eventually([&] {
      std::erase_if(asked, [&](std::int64_t sequence) {
        const auto answer = client.take_goal(sequence);
        if (!answer) return false;
        ++answered;
        accepted += answer->is_accepted ? 1 : 0;
        return true;
      });
      return asked.empty();
    })) << answered
        << err();
  }
  EXPECT_EQ(accepted, kMax);
  const auto canceled = client.cancel({});
  ASSERT_TRUE(canceled.has_value()) << err();
  EXPECT_THAT(canceled->canceling, SizeIs(kMax));
  ASSERT_TRUE(eventually([&] {
    const auto& lists = client.status_lists();
    return !lists.empty() && std::ranges::all_of(lists.back(), [](const plain::GoalState& goal) {
      return goal.status == GoalStatus::canceled;
    });
  })) << err();
}

TEST_F(ActionFaults, OneIdSentByManyAtOnceIsOneGoal) {
  constexpr int kClients = 5, kEach = 10;
  const plain::GoalId id = next_id();
  std::vector<std::unique_ptr<plain::ActionClient>> clients;
  for (int i = 0; i < kClients; ++i) {
    clients.push_back(std::make_unique<plain::ActionClient>(node_, "/together", navigate()));
    ASSERT_TRUE(clients.back()->wait_until_ready());
  }
  std::vector<std::pair<plain::ActionClient*, std::int64_t>> asked;
  for (int i = 0; i < kEach; ++i) {
    for (const auto& client : clients)
      asked.emplace_back(client.get(), client->ask_goal(id, navigate_goal("hold")));
  }
  int accepted = 0;
  ASSERT_TRUE(eventually([&] {
    std::erase_if(asked, [&](const auto& item) {
      const auto answer = item.first->take_goal(item.second);
      accepted += answer && answer->is_accepted ? 1 : 0;
      return answer.has_value();
    });
    return asked.empty();
  })) << err();
  EXPECT_EQ(accepted, 1);
  EXPECT_EQ(clients[0]->cancel({}).value().canceling.size(), 1U);
  for (const auto& client : clients) EXPECT_EQ(client->result(id).value().status, GoalStatus::canceled);
}

TEST_F(ActionFaults, CancelsOfWhatIsNotThereChangeNothing) {
  plain::ActionClient client(node_, "/preempting", navigate());
  const plain::GoalId driving = next_id();
  ASSERT_TRUE(client.send(driving, navigate_goal("hold")).value().is_accepted);
  EXPECT_EQ(client.cancel({.id = goal_id(0xfffffff0)}).value().code, CancelCode::unknown_goal_id);
  const auto before = client.cancel({.id = {}, .stamp = {.sec = 1}});  // in 1970
  EXPECT_EQ(before.value().code, CancelCode::none);
  EXPECT_THAT(before->canceling, IsEmpty());
  const auto negative = client.cancel({.id = {}, .stamp = {.sec = -5, .nanosec = 0xffffffff}});
  EXPECT_THAT(negative.value().canceling, IsEmpty());
  EXPECT_EQ(client.history(driving).back(), GoalStatus::executing);
  EXPECT_EQ(client.cancel({}).value().canceling.size(), 1U);
  EXPECT_EQ(client.cancel({}).value().canceling.size(), 0U);
  EXPECT_EQ(client.result(driving).value().status, GoalStatus::canceled);
  expect_forward(client.history(driving));
}

TEST_F(ActionFaults, AClientThatDiesLeavesItsGoalToTheNext) {
  // Two processes die: one right behind its goal, one while it waits for the result.
  const plain::GoalId id = next_id();
  plain::ActionClient heir(node_, "/preempting", navigate());
  const auto die_asking = [&](const std::string& service, const std::string& type,
                              const plain::Bytes& request, const std::function<bool()>& is_time) {
    Process client({PLAIN_CLIENT, "/preempting/_action/" + service, type, to_hex(request)});
    ASSERT_TRUE(eventually([&] { return client.out().starts_with("asked\n") && is_time(); })) << err();
    client.signal(SIGKILL);
    ASSERT_TRUE(client.wait(std::chrono::seconds(10)).has_value());
  };
  // Not before the server has heard of the goal: a request is lost that its writer did not live to repeat.
  die_asking("send_goal", std::string(kNavigateToPose) + "_SendGoal",
             plain::with_goal_id(id, navigate_goal("hold")), [&] {
               const auto history = heir.history(id);
               return !history.empty() && history.back() == GoalStatus::executing;
             });
  die_asking("get_result", std::string(kNavigateToPose) + "_GetResult", plain::CdrOut().octets(id).bytes(),
             [] { return true; });
  const plain::GoalId next = next_id();
  ASSERT_TRUE(heir.wait_until_ready());
  ASSERT_TRUE(heir.send(next, navigate_goal("steps 1")).value().is_accepted);
  EXPECT_EQ(heir.result(id).value().status, GoalStatus::aborted) << "preempted";
  EXPECT_EQ(heir.result(next).value().status, GoalStatus::succeeded);
}

TEST_F(ActionFaults, ACanceledGoalWhoseClientIsGoneEndsToo) {
  const plain::GoalId id = next_id();
  {
    auto dying = std::make_unique<plain::Node>("dying");
    plain::ActionClient client(*dying, "/together", navigate());
    ASSERT_TRUE(client.send(id, navigate_goal("slow 1000")).value().is_accepted);
    client.ask_result(id);
    client.ask_cancel({.id = id});
    ASSERT_TRUE(eventually([&] {
      const auto history = client.history(id);
      return !history.empty() && history.back() >= GoalStatus::canceling;
    }));
  }
  plain::ActionClient late(node_, "/together", navigate());
  EXPECT_EQ(late.result(id).value().status, GoalStatus::canceled);
}

/// The lifecycle of the server's node, as `ros2 lifecycle set` changes it.
bool change_state(plain::Node& node, std::uint8_t transition) {
  plain::Client client(node, "/server/change_state",
                       {.name = "lifecycle_msgs/srv/ChangeState", .request_hash = {}, .response_hash = {}});
  const auto reply = client.call(plain::CdrOut().number(transition).text("").bytes());
  return reply && plain::CdrIn(*reply).number<std::uint8_t>() == 1;
}

TEST_F(ActionFaults, WhoIsNotActiveRefusesGoalsAndItsOpenOnesWereAborted) {
  constexpr std::uint8_t kActivate = 3, kDeactivate = 4;
  plain::ActionClient client(node_, "/together", navigate());
  const plain::GoalId open = next_id(), refused = next_id();
  ASSERT_TRUE(client.send(open, navigate_goal("hold")).value().is_accepted);
  const std::int64_t waiting = client.ask_result(open);
  ASSERT_TRUE(change_state(node_, kDeactivate)) << err();
  std::optional<plain::Result> result;
  ASSERT_TRUE(eventually([&] { return (result = client.take_result(waiting)).has_value(); })) << err();
  EXPECT_EQ(result->status, GoalStatus::aborted);
  EXPECT_EQ(result->fields.number<std::uint16_t>(), kAbandoned);
  EXPECT_THAT(result->fields.text(), HasSubstr("server is not active"));
  EXPECT_FALSE(client.send(refused, navigate_goal("succeed")).value().is_accepted);
  EXPECT_EQ(client.result(refused).value().status, GoalStatus::unknown);
  EXPECT_EQ(client.result(open).value().status, GoalStatus::aborted) << "still known";
  EXPECT_EQ(client.cancel({}).value().canceling.size(), 0U);
  ASSERT_TRUE(change_state(node_, kActivate)) << err();
  EXPECT_TRUE(client.send(refused, navigate_goal("succeed")).value().is_accepted) << "an id refused is free";
  expect_forward(client.history(open));
}

TEST(ActionBeforeItsServer, AClientThatWaitsIsServedAndOneThatDoesNotIsNotAnswered) {
  plain::Node node("early");
  plain::ActionClient client(node, "/together", Jazzy::navigate_to_pose());
  const std::int64_t lost = client.ask_goal(goal_id(1), navigate_goal("succeed"));
  ActionProcess server({"serve", "jazzy"});
  ASSERT_TRUE(client.send(goal_id(2), navigate_goal("succeed")).value().is_accepted);
  EXPECT_FALSE(client.take_goal(lost).has_value());
  EXPECT_EQ(client.result(goal_id(1)).value().status, GoalStatus::unknown);
  EXPECT_EQ(client.result(goal_id(2)).value().status, GoalStatus::succeeded);
  EXPECT_EQ(server.stop(), 0) << server.process().err();
}

}  // namespace
}  // namespace bw::test
