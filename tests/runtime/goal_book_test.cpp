// Expected states and answers: rcl_action's goal state machine and action_msgs/srv/CancelGoal.
#include "runtime/ros/goal_book.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

GoalId id(std::uint8_t n) { return {n}; }
Time at(double seconds) { return Time{} + Duration::seconds(seconds); }

GoalBook book_of(int goals) {
  GoalBook book(Duration::seconds(10.0));
  for (int n = 1; n <= goals; ++n)
    EXPECT_TRUE(book.accept(id(static_cast<std::uint8_t>(n)), at(static_cast<double>(n))));
  return book;
}

GoalStatus status(const GoalBook& book, std::uint8_t n) { return book.find(id(n))->status; }

TEST(GoalBook, AGoalGoesFromAcceptedToOneEnd) {
  GoalBook book = book_of(1);
  EXPECT_EQ(status(book, 1), GoalStatus::accepted);
  EXPECT_TRUE(book.execute(id(1)));
  EXPECT_FALSE(book.execute(id(1)));
  EXPECT_EQ(status(book, 1), GoalStatus::executing);
  EXPECT_TRUE(book.finish(id(1), GoalStatus::succeeded, {7}, at(2.0)));
  EXPECT_FALSE(book.finish(id(1), GoalStatus::aborted, {8}, at(3.0)));
  EXPECT_FALSE(book.execute(id(1)));
  EXPECT_EQ(status(book, 1), GoalStatus::succeeded);
  EXPECT_EQ(book.find(id(1))->result, std::vector<std::uint8_t>{7});
}

TEST(GoalBook, AnIdIsTakenOnce) {
  GoalBook book = book_of(1);
  EXPECT_FALSE(book.accept(id(1), at(5.0)));
  book.finish(id(1), GoalStatus::succeeded, {}, at(5.0));
  EXPECT_FALSE(book.accept(id(1), at(6.0))) << "its result is kept";
}

TEST(GoalBook, OnlySoManyAreOpen) {
  GoalBook book(Duration::seconds(10.0));
  for (std::size_t n = 0; n < GoalBook::kMaxOpen; ++n) {
    EXPECT_TRUE(
        book.accept({static_cast<std::uint8_t>(n % 256), static_cast<std::uint8_t>(n / 256), 1}, at(1.0)));
  }
  EXPECT_FALSE(book.accept(id(1), at(1.0)));
  book.finish(book.goals().front().id, GoalStatus::aborted, {}, at(2.0));
  EXPECT_TRUE(book.accept(id(1), at(2.0)));
}

TEST(GoalBook, OneGoalIsCanceledByItsId) {
  GoalBook book = book_of(3);
  const CanceledGoals answer = book.cancel({.id = id(2), .stamp = {}});
  EXPECT_EQ(answer.code, GoalBook::kNone);
  ASSERT_EQ(answer.goals.size(), 1U);
  EXPECT_EQ(answer.goals[0].id, id(2));
  EXPECT_EQ(answer.goals[0].accepted, at(2.0));
  EXPECT_EQ(status(book, 2), GoalStatus::canceling);
  EXPECT_EQ(status(book, 1), GoalStatus::accepted);
}

TEST(GoalBook, AllAreCanceledWithoutIdAndStamp) {
  GoalBook book = book_of(3);
  book.finish(id(1), GoalStatus::succeeded, {}, at(3.0));
  EXPECT_EQ(book.cancel({}).goals.size(), 2U);
  EXPECT_EQ(book.cancel({}).goals.size(), 0U) << "they are being canceled already";
  EXPECT_EQ(book.cancel({}).code, GoalBook::kNone);
}

TEST(GoalBook, AStampCancelsAllUpToIt) {
  GoalBook book = book_of(4);
  EXPECT_EQ(book.cancel({.id = {}, .stamp = at(2.0)}).goals.size(), 2U);
  EXPECT_EQ(status(book, 3), GoalStatus::accepted);
  EXPECT_EQ(book.cancel({.id = id(4), .stamp = at(2.5)}).goals.size(), 1U) << "1 and 2 are canceled already";
  EXPECT_EQ(status(book, 4), GoalStatus::canceling);
}

TEST(GoalBook, WhatCannotBeCanceledSaysWhy) {
  GoalBook book = book_of(1);
  EXPECT_EQ(book.cancel({.id = id(9), .stamp = {}}).code, GoalBook::kUnknownGoal);
  EXPECT_EQ(book.cancel({.id = id(9), .stamp = at(0.5)}).code, GoalBook::kNone)
      << "beside a stamp an id is one more, and nothing is wrong without it, as in rcl_action";
  book.cancel({.id = id(1), .stamp = {}});
  EXPECT_EQ(book.cancel({.id = id(1), .stamp = {}}).code, GoalBook::kTerminated) << "twice";
  book.finish(id(1), GoalStatus::canceled, {}, at(2.0));
  EXPECT_EQ(status(book, 1), GoalStatus::canceled);
  EXPECT_EQ(book.cancel({.id = id(1), .stamp = {}}).code, GoalBook::kTerminated);
}

TEST(GoalBook, NobodyEndsCanceledWhoWasNotAsked) {
  GoalBook book = book_of(1);
  EXPECT_TRUE(book.finish(id(1), GoalStatus::canceled, {}, at(2.0)));
  EXPECT_EQ(status(book, 1), GoalStatus::aborted);
}

TEST(GoalBook, ResultsAreForgottenInTime) {
  GoalBook book = book_of(2);
  book.finish(id(1), GoalStatus::succeeded, {}, at(5.0));
  book.forget_old(at(15.0));
  EXPECT_NE(book.find(id(1)), nullptr);
  book.forget_old(at(15.1));
  EXPECT_EQ(book.find(id(1)), nullptr);
  EXPECT_NE(book.find(id(2)), nullptr) << "open goals stay";
}

}  // namespace
}  // namespace bw
