#include "runtime/recording/replay/input_order.hpp"

#include <gmock/gmock.h>

#include "runtime/recording/bag/bag_writer.hpp"
#include "tests/folder.hpp"
#include "tests/runtime/recording/replay/messages.hpp"

namespace bw::replay {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Time at_ms(std::int64_t ms) { return {ms * 1'000'000}; }

RecordedInput input(std::uint64_t number, const char* topic, std::int64_t ms) {
  return {.number = number, .topic = topic, .log_time = at_ms(ms), .stamp = at_ms(ms)};
}

FirstDifference difference(std::int64_t ms, std::int64_t stamp_ms = -1) {
  return {.topic = "/tracks",
          .time = at_ms(ms),
          .stamped_topic = "/tracks",
          .stamp = at_ms(stamp_ms),
          .period = Duration::milliseconds(100)};
}

/// "/scan after /odom": of each exchange, in their order.
std::vector<std::string> texts(const std::vector<Exchange>& exchanges) {
  std::vector<std::string> all;
  for (const Exchange& e : exchanges)
    all.push_back(std::to_string(e.moved.number) + (e.is_after() ? " after " : " before ") +
                  std::to_string(e.past.number));
  return all;
}

TEST(InputOrder, TwoOfDifferentTopicsCloseTogetherMayHaveComeEitherWay) {
  // 0 and 1 are 3 ms apart; 2 is of the topic of 1; 3 is 51 ms behind 2, more than kCloseTogether.
  const std::vector<RecordedInput> inputs = {input(0, "/scan", 0), input(1, "/odom", 3),
                                             input(2, "/odom", 50), input(3, "/scan", 101)};
  const auto exchanges = exchanges_around(difference(60), inputs);
  // The closest first. Behind both, or before both: two ways where one is between.
  EXPECT_THAT(texts(exchanges), ElementsAre("0 after 1", "0 after 2", "2 before 0"));
  EXPECT_THAT(exchanges[0].delays, ElementsAre(Delay{0, 1}));
  EXPECT_THAT(exchanges[1].delays, ElementsAre(Delay{0, 2}));
  EXPECT_THAT(exchanges[2].delays, ElementsAre(Delay{0, 2}, Delay{1, 2}));
  EXPECT_EQ(exchanges[2].apart(), Duration::milliseconds(50));
}

TEST(InputOrder, WhatTheOutputAnswersIsTheLikeliest) {
  const std::vector<RecordedInput> inputs = {input(0, "/tf", 0), input(1, "/odom", 1), input(2, "/scan", 20)};
  // The difference has the stamp of the scan: its pairs come before the closer one of /tf and /odom.
  EXPECT_THAT(texts(exchanges_around(difference(30, 20), inputs)),
              ElementsAre("1 after 2", "0 after 2", "2 before 0", "0 after 1"));
}

/// Scans every 100 ms, from 100 ms on, with odometry 1 ms before each: numbers 2 k and 2 k + 1 from k = 0.
class InputOrderOfABag : public testing::Test {
 protected:
  void SetUp() override {
    bag::BagWriter writer(folder_ / "bag.mcap", {});
    for (const char* topic : {"/odom", "/scan", "/tracks"})
      writer.add_topic({.name = topic, .type = "geometry_msgs/msg/TwistStamped", .writer = "world"});
    for (int k = 1; k <= 5; ++k) {
      const auto stamp = twist(0.1 * k, 0.0);
      writer.write(0, at_ms(100 * k - 1), at_ms(100 * k - 1), stamp);
      writer.write(1, at_ms(100 * k), at_ms(100 * k), stamp);
    }
    // Answers to the scans, and one to a scan of 600 ms that the bag does not have.
    for (int k = 1; k <= 6; ++k)
      writer.write(2, at_ms(550 + 10 * k), at_ms(550 + 10 * k), twist(0.1 * k, 0.0));
    writer.close();
    bag_ = bag::open_bag(folder_ / "bag.mcap");
  }
  OrderVerdict explain(const FirstDifference& first, const TryOrder& replay_with,
                       Duration budget = Duration::milliseconds(100'000)) const {
    return explain_by_order(*bag_, {"/odom", "/scan"}, first, budget, replay_with);
  }

  test::Folder folder_;
  std::unique_ptr<bag::Bag> bag_;
};

TEST_F(InputOrderOfABag, InputsAreThoseOfTheTopicsWithTheirOwnStamps) {
  const auto inputs = inputs_between(*bag_, {"/odom"}, at_ms(199), at_ms(400));
  ASSERT_EQ(inputs.size(), 3U);  // of 200, 300 and 400 ms
  EXPECT_EQ(inputs[0].number, 2U);
  EXPECT_EQ(inputs[0].log_time, at_ms(199));
  EXPECT_EQ(inputs[0].stamp, at_ms(200));
}

TEST_F(InputOrderOfABag, OneAfterAnotherIsExplained) {
  // The component took the second and the fourth scan before the odometry that the bag has before it.
  const std::vector<std::pair<Delay, std::int64_t>> truth = {{{2, 3}, 200}, {{6, 7}, 400}};
  int runs = 0;
  const auto replay_with = [&](const std::vector<Delay>& delays, std::optional<Time> end) {
    ++runs;
    for (const auto& [delay, ms] : truth) {
      const bool is_taken = std::ranges::find(delays, delay) != delays.end();
      if (!is_taken && (!end || at_ms(ms) <= *end)) return std::optional(difference(ms, ms));
    }
    return std::optional<FirstDifference>();
  };
  const OrderVerdict verdict = explain(difference(200, 200), replay_with);
  EXPECT_THAT(texts(verdict.taken), ElementsAre("2 after 3", "6 after 7"));
  EXPECT_FALSE(verdict.left);
  EXPECT_THAT(verdict.close, IsEmpty());
  EXPECT_EQ(runs, 4)
      << "each exchange is the likeliest of its difference: tried once, and all of the bag once";
}

TEST_F(InputOrderOfABag, ADifferenceOfTheCodeIsNotExplained) {
  const auto never = [](const std::vector<Delay>&, std::optional<Time>) {
    return std::optional(difference(200, 200));
  };
  const OrderVerdict verdict = explain(difference(200, 200), never);
  EXPECT_THAT(verdict.taken, IsEmpty());
  ASSERT_TRUE(verdict.left);
  EXPECT_EQ(verdict.left->time, at_ms(200));
  // Within a period of the difference, 100 to 300 ms; the scan of 100 ms is 99 ms from the next odometry.
  EXPECT_THAT(texts(verdict.close), ElementsAre("2 after 3", "4 after 5"));
  EXPECT_EQ(verdict.tried, 2U);
}

TEST_F(InputOrderOfABag, WhatTheRecorderDidNotHearIsSaidAndNoOrderTried) {
  int runs = 0;
  const auto never = [&](const std::vector<Delay>&, std::optional<Time>) {
    ++runs;
    return std::optional(difference(610, 600));
  };
  const OrderVerdict verdict = explain(difference(610, 600), never);
  EXPECT_TRUE(verdict.lacks_input);
  EXPECT_EQ(runs, 0);
  EXPECT_FALSE(explain(difference(600, 500), never).lacks_input) << "this one is there";
  EXPECT_FALSE(lacks_its_input(*bag_, {"/none"}, difference(610, 600)))
      << "where messages answer no input by their stamps, a stamp of no input says nothing";
}

TEST_F(InputOrderOfABag, AnEarlierDifferenceIsNoExplanation) {
  const auto worse = [](const std::vector<Delay>&, std::optional<Time>) {
    return std::optional(difference(100, 100));
  };
  EXPECT_THAT(explain(difference(200, 200), worse).taken, IsEmpty());
}

TEST_F(InputOrderOfABag, TheBudgetEndsTheSearchAfterOneTry) {
  int runs = 0;
  const auto never = [&](const std::vector<Delay>&, std::optional<Time>) {
    ++runs;
    return std::optional(difference(300, 300));
  };
  const FirstDifference wide{.topic = "/tracks",
                             .time = at_ms(300),
                             .stamped_topic = "/tracks",
                             .stamp = at_ms(300),
                             .period = Duration::milliseconds(250)};
  const OrderVerdict verdict = explain(wide, never, Duration{});
  EXPECT_EQ(runs, 1);
  EXPECT_EQ(verdict.tried, 1U);
  EXPECT_GT(verdict.close.size(), 1U);
}

}  // namespace
}  // namespace bw::replay
