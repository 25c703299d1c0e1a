// 1,000 goals in lock-step, with random scripts, preemptions and cancels: of one goal, of all, up to a time,
// twice, of unknown ones. Whatever happens, each goal ends in one terminal state, and what is told of it
// never goes back.
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <nav2_msgs/action/navigate_to_pose.hpp>

#include "runtime/host/host.hpp"
#include "runtime/stamps.hpp"
#include "tests/runtime/scripted.hpp"
#include "tests/runtime/scripted_actions.hpp"

namespace bw::test {
namespace {

using action_msgs::msg::GoalStatusArray;
using action_msgs::srv::CancelGoal;
using nav2_msgs::action::NavigateToPose;

constexpr std::size_t kGoals = 1000;

/// What was heard of one goal.
struct Story {
  std::string script;
  int acknowledged = 0;
  int results = 0;
  GoalStatus end = GoalStatus::unknown;
  std::uint16_t code = 0;
  std::vector<GoalStatus> told;  ///< by the status topic, each once
  bool was_asked_to_cancel = false;
  bool had_feedback_after_its_end = false;
};

/// Sends goals and cancels as chance says, until all of them are over.
class RandomClient {
 public:
  using Stories = std::map<GoalId, Story>;

  static void run(Setup& setup, const std::string& action, Stories& stories) {
    auto self = std::make_shared<RandomClient>(setup, action, stories);
    setup.input<GoalStatusArray>(
        action + "/_action/status", Qos{.durability = Durability::transient_local},
        [self](const GoalStatusArray& message, const Tick&) { self->hear(message); }, Need::optional);
    setup.every(Duration::milliseconds(20), "act", [self, finish = setup.finish_run()](const Tick& tick) {
      self->act(tick.now);
      if (self->is_over()) finish(true, "all goals are over");
    });
  }

  RandomClient(Setup& setup, const std::string& action, Stories& stories)
      : client_(setup.action_client<NavigateToPose>(action)),
        cancel_(setup.client<CancelGoal>(action + "/_action/cancel_goal")),
        random_(setup.seed()),
        stories_(stories) {}

 private:
  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }

  bool is_over() const {
    return sent_.size() == kGoals &&
           std::ranges::all_of(stories_, [](const auto& item) { return item.second.results == 1; });
  }

  void act(Time now) {
    for (int goals = below(3); goals > 0 && sent_.size() < kGoals; --goals) send();
    if (sent_.empty()) return;
    const int chance = below(20);
    if (chance < 5) cancel_one(sent_[static_cast<std::size_t>(below(static_cast<int>(sent_.size())))]);
    if (chance < 3) cancel_one(sent_.back());
    if (chance == 6) cancel_one(GoalId{1, 2, 3});
    if (chance == 7) cancel_until(now - Duration::milliseconds(below(200)));
    if (chance == 8 || (sent_.size() == kGoals && chance > 8)) cancel_until({});
  }

  void send() {
    constexpr std::array<const char*, 7> kScripts = {"succeed", "abort", "wait", "hold",
                                                     "steps",   "slow",  "deaf"};
    const std::string script =
        std::string(kScripts[static_cast<std::size_t>(below(7))]) + " " + std::to_string(1 + below(20));
    NavigateToPose::Goal goal;
    goal.behavior_tree(script);
    auto id = std::make_shared<GoalId>();
    GoalCallbacks<NavigateToPose> callbacks;
    callbacks.on_acknowledged = [this, id](bool accepted, const Tick&) {
      stories_[*id].acknowledged += accepted ? 1 : 100;
    };
    callbacks.on_feedback = [this, id](const NavigateToPose::Feedback&, const Tick&) {
      if (stories_[*id].results > 0) stories_[*id].had_feedback_after_its_end = true;
    };
    callbacks.on_result = [this, id](GoalStatus status, const NavigateToPose::Result* result, const Tick&) {
      Story& story = stories_[*id];
      ++story.results;
      story.end = status;
      story.code = result == nullptr ? 0xffff : result->error_code();
    };
    *id = client_.send(goal, Duration::seconds(1.0), std::move(callbacks));
    stories_[*id].script = script;
    sent_.push_back(*id);
  }

  void cancel_one(const GoalId& id) {
    if (stories_.contains(id)) stories_[id].was_asked_to_cancel = true;
    client_.cancel(id);
  }

  void cancel_until(Time end) {
    CancelGoal::Request request;
    if (end != Time{}) request.goal_info().stamp(to_stamp(end));
    cancel_.call(request, Duration::seconds(1.0), [this](const CancelGoal::Response* response, const Tick&) {
      ASSERT_NE(response, nullptr);
      for (const auto& goal : response->goals_canceling())
        stories_[goal.goal_id().uuid()].was_asked_to_cancel = true;
    });
  }

  void hear(const GoalStatusArray& message) {
    for (const auto& goal : message.status_list()) {
      auto& told = stories_[goal.goal_info().goal_id().uuid()].told;
      const auto status = static_cast<GoalStatus>(goal.status());
      if (told.empty() || told.back() != status) told.push_back(status);
    }
  }

  ActionClient<NavigateToPose> client_;
  Client<CancelGoal> cancel_;
  std::mt19937_64 random_;
  Stories& stories_;
  std::vector<GoalId> sent_;
};

struct Outcome {
  RandomClient::Stories stories;
  std::string hash;
};

Outcome drive(std::uint64_t seed, Policy policy, Duration latency) {
  Outcome run;
  Graph graph;
  graph.components.push_back(scripted({.name = "server", .latency = latency}, [&](bw::Setup& setup) {
    ScriptedActions<NavigateToPose>::offer(setup, "go", policy);
  }));
  graph.components.push_back(
      scripted({.name = "client"}, [&](bw::Setup& setup) { RandomClient::run(setup, "go", run.stories); }));
  Host host(graph, {.clock = ClockMode::lockstep, .seed = seed});
  const RunEnd end = host.run(Duration::seconds(120.0));
  EXPECT_TRUE(end.ok) << end.reason;
  EXPECT_EQ(end.reason, "all goals are over");
  run.hash = host.samples_sha256();
  return run;
}

void expect_sound(const Story& story, Policy policy) {
  SCOPED_TRACE(story.script);
  EXPECT_EQ(story.acknowledged, 1) << "accepted, once";
  EXPECT_EQ(story.results, 1);
  EXPECT_TRUE(is_final(story.end));
  EXPECT_FALSE(story.had_feedback_after_its_end);
  ASSERT_FALSE(story.told.empty());
  EXPECT_EQ(story.told.back(), story.end);
  EXPECT_TRUE(std::ranges::is_sorted(story.told));
  EXPECT_EQ(std::ranges::count_if(story.told, is_final), 1);
  const std::string word = story.script.substr(0, story.script.find(' '));
  const bool was_preempted = story.code == static_cast<std::uint16_t>(Ending::preempted);
  if (was_preempted) {
    EXPECT_EQ(policy, Policy::preempting);
    EXPECT_EQ(story.end, GoalStatus::aborted);
  } else if (word == "succeed" || word == "deaf") {
    EXPECT_EQ(story.end, GoalStatus::succeeded);
  } else if (word == "abort") {
    EXPECT_EQ(story.end, GoalStatus::aborted);
  } else if (word == "wait" || word == "hold") {
    EXPECT_EQ(story.end, GoalStatus::canceled);
  }
  if (story.end == GoalStatus::canceled) {
    EXPECT_TRUE(story.was_asked_to_cancel);
  }
}

class RandomGoals : public testing::TestWithParam<Policy> {};

TEST_P(RandomGoals, EndOnceAndNeverGoBackWhateverTheSeed) {
  std::set<GoalStatus> ends;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Outcome run = drive(seed, GetParam(), Duration::milliseconds(seed % 2 == 0 ? 3 : 0));
    EXPECT_EQ(run.stories.size(), kGoals);
    for (const auto& [id, story] : run.stories) {
      expect_sound(story, GetParam());
      ends.insert(story.end);
    }
  }
  EXPECT_EQ(ends.size(), 3U) << "succeeded, canceled and aborted";
}

TEST_P(RandomGoals, SayTheSameBytesWithTheSameSeed) {
  const Outcome first = drive(7, GetParam(), Duration::milliseconds(3));
  EXPECT_EQ(drive(7, GetParam(), Duration::milliseconds(3)).hash, first.hash);
  EXPECT_NE(drive(8, GetParam(), Duration::milliseconds(3)).hash, first.hash);
}

INSTANTIATE_TEST_SUITE_P(Policies, RandomGoals, testing::Values(Policy::together, Policy::preempting),
                         [](const auto& param) {
                           return param.param == Policy::together ? "Together" : "Preempting";
                         });

}  // namespace
}  // namespace bw::test
