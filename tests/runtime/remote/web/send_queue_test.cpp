#include "runtime/remote/web/send_queue.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace bw::web {
namespace {

constexpr QueueLimits kSmall = {.data_bytes = 40, .data_frames = 4, .control_bytes = 40, .control_frames = 3};

Keep always() { return {}; }
Keep newest(std::uint64_t stream) { return {Keep::Rule::newest, stream}; }
Keep latched(std::uint64_t stream) { return {Keep::Rule::latched, stream}; }

/// What is queued, in order; the queue is empty afterwards.
std::string contents(SendQueue& queue) {
  std::string all;
  while (const auto frame = queue.pop()) {
    all += all.empty() ? "" : " ";
    for (const auto byte : frame->head.bytes()) all += static_cast<char>(byte);
    if (frame->body) all.append(frame->body->begin(), frame->body->end());
  }
  return all;
}

TEST(SendQueue, KeepsTheOrderInWhichFramesWereGiven) {
  SendQueue queue(kSmall);
  ASSERT_TRUE(queue.push(text_frame("info"), always()));
  ASSERT_TRUE(queue.push(text_frame("scan1"), newest(1)));
  ASSERT_TRUE(queue.push(text_frame("map"), latched(2)));
  ASSERT_TRUE(queue.push(text_frame("scan2"), newest(1)));
  EXPECT_EQ(queue.frames(), 4U);
  EXPECT_EQ(queue.bytes(), 17U);
  EXPECT_EQ(contents(queue), "info scan1 map scan2");
  EXPECT_EQ(queue.bytes(), 0U);
}

TEST(SendQueue, FullItLosesOlderDataAndKeepsTheNewestOfEachStream) {
  SendQueue queue(kSmall);
  ASSERT_TRUE(queue.push(text_frame("rare"), newest(9)));
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(queue.push(text_frame("s" + std::to_string(i)), newest(1)));
  // 4 frames may wait: `rare` is the newest of its stream, and three of the other.
  EXPECT_EQ(queue.left_out(), 17U);
  EXPECT_EQ(contents(queue), "rare s17 s18 s19");
}

TEST(SendQueue, TheNewestOfEachStreamStaysEvenBeyondTheBound) {
  SendQueue queue(kSmall);
  for (std::uint64_t stream = 0; stream < 8; ++stream) {
    ASSERT_TRUE(queue.push(text_frame("old"), newest(stream)));
  }
  for (std::uint64_t stream = 0; stream < 8; ++stream) {
    ASSERT_TRUE(queue.push(text_frame("n" + std::to_string(stream)), newest(stream)));
  }
  EXPECT_EQ(contents(queue), "n0 n1 n2 n3 n4 n5 n6 n7");
}

TEST(SendQueue, BoundsBytesAsWell) {
  SendQueue queue(kSmall);
  for (int i = 0; i < 3; ++i)
    ASSERT_TRUE(queue.push(text_frame(std::string(18, 'a' + static_cast<char>(i))), newest(1)));
  EXPECT_EQ(queue.bytes(), 36U);
  EXPECT_EQ(contents(queue), std::string(18, 'b') + ' ' + std::string(18, 'c'));
}

TEST(SendQueue, OfALatchedStreamOnlyTheNewestWaits) {
  SendQueue queue(kSmall);
  ASSERT_TRUE(queue.push(text_frame("map1"), latched(1)));
  ASSERT_TRUE(queue.push(text_frame("status"), always()));
  ASSERT_TRUE(queue.push(text_frame("map2"), latched(1)));
  EXPECT_EQ(contents(queue), "status map2");
}

TEST(SendQueue, LatchedFramesStayHoweverMuchDataComes) {
  SendQueue queue(kSmall);
  ASSERT_TRUE(queue.push(text_frame(std::string(1000, 'm')), latched(1)));
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(queue.push(text_frame("scan"), newest(2)));
  EXPECT_EQ(queue.frames(), 5U);
  EXPECT_EQ(queue.pop()->size(), 1000U);
}

TEST(SendQueue, TooManyAnswersAreRefused) {
  SendQueue queue(kSmall);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(queue.push(text_frame("a"), always()));
  EXPECT_FALSE(queue.push(text_frame("a"), always()));
  EXPECT_EQ(queue.frames(), 3U);
}

TEST(SendQueue, OneAnswerMayBeLargerThanTheBoundIfItIsAlone) {
  SendQueue queue(kSmall);
  EXPECT_TRUE(queue.push(text_frame(std::string(1000, 'a')), always()));
  EXPECT_FALSE(queue.push(text_frame("b"), always()));
}

// Against a plain model: frames stay in order, the newest of each stream and all others are there, and
// nothing grows beyond the bounds.
TEST(SendQueue, HoldsItsRulesForAnyOrderOfCalls) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    SendQueue queue({.data_bytes = 60, .data_frames = 6, .control_bytes = 1 << 20, .control_frames = 1000});
    std::vector<int> control;
    std::vector<int> last_of(3, -1);
    int last_popped = -1;
    for (int i = 0; i < 300; ++i) {
      const auto kind = random() % 6;
      Frame frame = text_frame(std::to_string(i));
      if (kind < 3) {
        last_of[kind] = i;
        ASSERT_TRUE(queue.push(std::move(frame), newest(kind)));
        ASSERT_LE(queue.frames(), control.size() + 6);
      } else if (kind == 3) {
        control.push_back(i);
        ASSERT_TRUE(queue.push(std::move(frame), always()));
      } else if (const auto popped = queue.pop()) {
        const int number = std::stoi(std::string(popped->body->begin(), popped->body->end()));
        ASSERT_GT(number, last_popped);
        last_popped = number;
        std::erase(control, number);
        for (int& last : last_of) last = last == number ? -1 : last;
      }
    }
    std::vector<int> rest;
    while (const auto popped = queue.pop())
      rest.push_back(std::stoi(std::string(popped->body->begin(), popped->body->end())));
    for (const int number : control) EXPECT_EQ(std::count(rest.begin(), rest.end(), number), 1);
    for (const int number : last_of)
      EXPECT_EQ(std::count(rest.begin(), rest.end(), number), number < 0 ? 0 : 1);
    EXPECT_TRUE(std::is_sorted(rest.begin(), rest.end()));
  }
}

}  // namespace
}  // namespace bw::web
