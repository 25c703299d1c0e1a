// `bandwagon action list`, `info` and `send` against our server in two layouts, and against one on plain Fast
// DDS that tells no type hashes, as Humble's.
#include <thread>

#include <gmock/gmock.h>

#include "tests/interop/action_process.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/plain/action_server.hpp"

namespace bw::test {
namespace {

using plain::GoalStatus;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;

std::vector<std::string> action(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {BANDWAGON_PROGRAM, "action"});
  return arguments;
}

Outcome run_action(const std::vector<std::string>& arguments) {
  return run_to_end(action(arguments), std::chrono::seconds(60));
}

class ActionVerb : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    server_ = std::make_unique<ActionProcess>(std::vector<std::string>{"serve", "jazzy"});
  }
  static void TearDownTestSuite() {
    EXPECT_EQ(server_->stop(), 0) << server_->process().err();
    server_.reset();
  }
  static std::unique_ptr<ActionProcess> server_;
};

std::unique_ptr<ActionProcess> ActionVerb::server_;

TEST_F(ActionVerb, ListNamesOneALineAndTellsTypes) {
  const Outcome list = run_action({"list"});
  EXPECT_EQ(list.status, 0) << list.err;
  EXPECT_EQ(list.out, "/follow\n/preempting\n/together\n");
  EXPECT_EQ(run_action({"list", "-t"}).out,
            "/follow [nav2_msgs/action/FollowPath]\n/preempting [nav2_msgs/action/NavigateToPose]\n"
            "/together [nav2_msgs/action/NavigateToPose]\n");
  EXPECT_THAT(run_action({"list", "--json"}).out, HasSubstr("\"/follow\": \"nav2_msgs/action/FollowPath\""));
}

TEST_F(ActionVerb, InfoNamesServersAndClients) {
  plain::Node node("client_of_goals");
  plain::ActionClient client(node, "/together", Jazzy::navigate_to_pose());
  // Discovery of one newcomer by another takes its time.
  Outcome info;
  EXPECT_TRUE(eventually([&] {
    info = run_action({"info", "/together"});
    return info.out ==
           "Action: /together\nType: nav2_msgs/action/NavigateToPose\nAction clients: 1\n"
           "    /client_of_goals\nAction servers: 1\n    /server\n";
  })) << info.out
      << info.err;
  EXPECT_EQ(info.status, 0);
  const Outcome none = run_action({"info", "/togethr"});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("/togethr: unknown action; did you mean '/together'?"));
}

TEST_F(ActionVerb, SendPrintsTheResultAndEndsInZeroWhenTheGoalSucceeds) {
  const std::string goal =
      "{pose: {header: {frame_id: map}, pose: {position: {x: 1.0}}}, behavior_tree: steps 2}";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"send", "/together", "nav2_msgs/action/NavigateToPose", goal},
        std::vector<std::string>{"send_goal", "/together", goal}}) {
    const Outcome send = run_action(arguments);
    EXPECT_EQ(send.status, 0) << send.err;
    EXPECT_THAT(send.out, MatchesRegex("Goal accepted with ID: [0-9a-f]+\nresult:\n  error_code: 0\n"
                                       "  error_msg: ''\nGoal finished with status: SUCCEEDED\n"));
  }
}

TEST_F(ActionVerb, SendPrintsFeedbackWhenAsked) {
  const Outcome send = run_action({"send", "/together", "{behavior_tree: steps 2}", "--feedback"});
  EXPECT_EQ(send.status, 0) << send.err;
  const std::size_t first = send.out.find("  distance_remaining: 1.0\n---\n");
  const std::size_t second = send.out.find("  distance_remaining: 0.0\n---\n");
  EXPECT_NE(first, std::string::npos) << send.out;
  EXPECT_NE(second, std::string::npos) << send.out;
  EXPECT_LT(first, second);
  EXPECT_LT(second, send.out.find("result:"));
  EXPECT_THAT(send.out, HasSubstr("feedback:\n  current_pose:\n    header:\n"));
}

TEST_F(ActionVerb, AGoalThatDoesNotSucceedIsExitStatusOne) {
  const Outcome aborted = run_action({"send", "/together", "{behavior_tree: abort}"});
  EXPECT_EQ(aborted.status, 1) << aborted.err;
  EXPECT_THAT(aborted.out, HasSubstr("result:\n  error_code: 42\n  error_msg: told to\n"
                                     "Goal finished with status: ABORTED\n"));
}

/// Sends a goal, interrupts once it drives, and waits for its end.
Outcome interrupted(const std::string& text) {
  Process send(action({"send", "/together", "{behavior_tree: " + text + "}", "--feedback"}));
  EXPECT_TRUE(eventually([&] { return send.out().find("---") != std::string::npos; })) << send.err();
  send.signal(SIGINT);
  const int status = send.wait(std::chrono::seconds(30)).value_or(-1);
  return {.status = status, .out = send.out(), .err = send.err()};
}

TEST_F(ActionVerb, CtrlCCancelsTheGoalAndWaitsForItsEnd) {
  const Outcome slow = interrupted("slow 100000");
  EXPECT_EQ(slow.status, 1) << slow.err;
  EXPECT_THAT(slow.out, AllOf(HasSubstr("Canceling the goal\n"),
                              testing::EndsWith("Goal finished with status: CANCELED\n")));
  const Outcome deaf = interrupted("deaf 100");  // 2 s
  EXPECT_EQ(deaf.status, 0) << deaf.err;
  EXPECT_THAT(deaf.out, AllOf(HasSubstr("Canceling the goal\n"),
                              testing::EndsWith("Goal finished with status: SUCCEEDED\n")))
      << "asked to cancel, the server went on";
}

TEST_F(ActionVerb, WrongUseIsExitStatusTwo) {
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& why) {
    const Outcome outcome = run_action(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr(why));
  };
  refused({"send", "/togethr", "{}"}, "/togethr: unknown action; did you mean '/together'?");
  refused({"send", "/together", "nav2_msgs/action/Spin", "{}"},
          "/together is a nav2_msgs/action/NavigateToPose, not a nav2_msgs/action/Spin");
  refused({"send", "/together", "{pose: {pose: {position: {x: far}}}}"},
          "goal:1: goal.pose.pose.position.x = far: must be a number");
  refused({"send", "/together", "{behaviour_tree: x}"},
          "goal.behaviour_tree: unknown field; did you mean 'behavior_tree'?");
  refused({"send", "/together", "{}", "--distro", "hum"}, "--distro: unknown distribution");
}

TEST(ActionVerbInHumble, TheLayoutIsThatOfTheHashesOfTheServer) {
  // In Jazzy's layout the result would be longer than what comes.
  ActionProcess server({"serve", "humble"});
  const Outcome send = run_action({"send", "/follow", "{controller_id: succeed}"});
  EXPECT_EQ(send.status, 0) << send.err;
  EXPECT_THAT(send.out, HasSubstr("Goal finished with status: SUCCEEDED\n"));
  EXPECT_THAT(send.out, testing::Not(HasSubstr("error_code")));
  EXPECT_EQ(run_action({"send", "/follow", "{progress_checker_id: x}"}).status, 2) << "Jazzy's field";
  EXPECT_EQ(server.stop(), 0) << server.process().err();
}

/// Humble's server of another hand: no hashes. Served while `verb` runs.
class PlainServerInHumble : public testing::Test {
 protected:
  PlainServerInHumble()
      : node_("plain", nullptr, plain::GidSize::humble),
        server_(std::make_unique<plain::ActionServer>(node_, "/plain", Humble::navigate_to_pose(),
                                                      Humble::no_result)) {}

  /// Does `each` with every new goal.
  template <class Each>
  Outcome serve(const std::vector<std::string>& arguments, Each each) {
    Process verb(action(arguments));
    return answer(verb, each);
  }
  template <class Each>
  Outcome answer(Process& verb, Each each) {
    std::size_t known = 0;
    EXPECT_TRUE(eventually([&] {
      if (server_) server_->answer();
      while (server_ && known < server_->goals().size()) each(server_->goals()[known++].state.info.id);
      return !verb.running();
    })) << verb.err();
    const int status = verb.wait(std::chrono::seconds(10)).value_or(-1);
    return {.status = status, .out = verb.out(), .err = verb.err()};
  }
  void succeed(const plain::GoalId& id) {
    server_->execute(id);
    server_->finish(id, GoalStatus::succeeded, Humble::no_result);
  }

  plain::Node node_;
  std::unique_ptr<plain::ActionServer> server_;
};

TEST_F(PlainServerInHumble, IsSpokenToInTheLayoutOfTheDistributionNamed) {
  const auto succeed_it = [this](const plain::GoalId& id) { succeed(id); };
  const Outcome told = serve({"send", "/plain", "{}", "--distro", "humble"}, succeed_it);
  EXPECT_EQ(told.status, 0) << told.err;
  const Outcome taken_for_jazzy = serve({"send", "/plain", "{}"}, succeed_it);
  EXPECT_EQ(taken_for_jazzy.status, 2);
  EXPECT_THAT(
      taken_for_jazzy.err,
      AllOf(HasSubstr("is no nav2_msgs/action/NavigateToPose_GetResult_Response"), HasSubstr("--distro")));
}

TEST_F(PlainServerInHumble, IsWaitedForWhereDiscoveryIsLate) {
  server_.reset();
  Process verb(action({"send", "/plain", "{}", "--distro", "humble"}));
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(eventually([&] {
    const bool is_late = std::chrono::steady_clock::now() - start > std::chrono::milliseconds(1'900);
    return is_late || !verb.running();
  }));
  server_ =
      std::make_unique<plain::ActionServer>(node_, "/plain", Humble::navigate_to_pose(), Humble::no_result);
  const Outcome send = answer(verb, [this](const plain::GoalId& id) { succeed(id); });
  EXPECT_EQ(send.status, 0) << send.err;
}

TEST_F(PlainServerInHumble, ARejectedGoalIsExitStatusOne) {
  server_->accepts = [](const plain::Bytes&) { return false; };
  const Outcome send = serve({"send", "/plain", "{}"}, [](const plain::GoalId&) {});
  EXPECT_EQ(send.status, 1) << send.err;
  EXPECT_EQ(send.out, "Goal was rejected.\n");
}

TEST_F(PlainServerInHumble, AServerThatGoesIsExitStatusOne) {
  Process verb(action({"send", "/plain", "{}"}));
  ASSERT_TRUE(eventually([&] {
    server_->answer();
    return verb.out().starts_with("Goal accepted");
  })) << verb.err();
  server_.reset();
  EXPECT_EQ(verb.wait(std::chrono::seconds(30)), 1);
  EXPECT_THAT(verb.err(), HasSubstr("/plain: the server is gone"));
}

TEST_F(PlainServerInHumble, OneThatDoesNotAnswerIsExitStatusOne) {
  const Outcome send = run_action({"send", "/plain", "{}", "--timeout", "0.5"});
  EXPECT_EQ(send.status, 1);
  EXPECT_THAT(send.err, HasSubstr("/plain did not acknowledge the goal within 0.5 s"));
}

}  // namespace
}  // namespace bw::test
