// The card of several robots is the worst of theirs, and over when all are.
#include "components/program/several_cards.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace bw {
namespace {

bandwagon_msgs::msg::ScoreCard card(bool finished, bool reached, double time, std::uint32_t contacts,
                                    double nearest) {
  bandwagon_msgs::msg::ScoreCard card;
  card.finished(finished);
  card.reached(reached);
  card.reason(reached ? "reached" : "blocked");
  card.time_to_goal_s(time);
  card.collisions(contacts);
  card.min_distance_m(nearest);
  return card;
}

TEST(SeveralCards, OfOneRobotItIsItsOwn) {
  EXPECT_FALSE(card_of_all({{"", std::nullopt}}));
  const auto own = card(true, false, 20.0, 1, 0.2);
  EXPECT_EQ(card_of_all({{"", own}}), own);
}

TEST(SeveralCards, IsOverWhenAllAreAndReachedWhenAllHave) {
  EXPECT_FALSE(card_of_all({{"a", card(true, true, 20, 0, 1)}, {"b", std::nullopt}})->finished());
  EXPECT_FALSE(card_of_all({{"a", std::nullopt}, {"b", card(true, true, 20, 0, 1)}})->reached());
  EXPECT_FALSE(
      card_of_all({{"a", card(true, true, 20, 0, 1)}, {"b", card(false, false, 9, 0, 1)}})->finished());
  EXPECT_TRUE(card_of_all({{"a", card(true, true, 20, 0, 1)}, {"b", card(true, true, 9, 0, 1)}})->reached());
  const auto failed = card_of_all({{"a", card(true, true, 20, 0, 1)}, {"b", card(true, false, 9, 0, 1)}});
  EXPECT_TRUE(failed->finished());
  EXPECT_FALSE(failed->reached());
  EXPECT_EQ(failed->reason(), "b: blocked");
  EXPECT_EQ(card_of_all({{"a", card(true, false, 9, 0, 1)}, {"b", card(true, true, 9, 0, 1)}})->reason(),
            "a: blocked");
}

TEST(SeveralCards, HasTheWorstFiguresAndTheContactsOfAll) {
  auto b = card(true, true, 25.0, 2, 0.3);
  b.localization_rms_m(std::numeric_limits<double>::quiet_NaN());
  auto a = card(true, true, 20.0, 1, 0.5);
  a.localization_rms_m(0.1);
  const auto all = card_of_all({{"a", a}, {"b", b}});
  EXPECT_EQ(all->time_to_goal_s(), 25.0);
  EXPECT_EQ(all->collisions(), 3U);
  EXPECT_EQ(all->min_distance_m(), 0.3);
  EXPECT_EQ(all->localization_rms_m(), 0.1);
}

}  // namespace
}  // namespace bw
