// People as others tell them.
#include "components/people/heard_people.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace bw::people {
namespace {

const Time kNow{5'000'000'000};

TEST(HeardPeople, KeepsIdsByNameAndOrder) {
  HeardPeople heard;
  const HeardPeopleOptions options;
  const auto first = heard.take({{.name = "ann"}, {.name = ""}, {.name = ""}}, kNow, options);
  ASSERT_EQ(first.size(), 3U);
  const auto second =
      heard.take({{.name = ""}, {.name = ""}, {.name = "bob"}, {.name = "ann"}}, kNow, options);
  ASSERT_EQ(second.size(), 4U);
  EXPECT_EQ(second[0].id, first[1].id);
  EXPECT_EQ(second[1].id, first[2].id);
  EXPECT_EQ(second[2].id, 4U);
  EXPECT_EQ(second[3].id, first[0].id);
}

TEST(HeardPeople, GivesThemSizeAndDoubt) {
  HeardPeople heard;
  HeardPeopleOptions options;
  options.radius = 0.4;
  options.position_deviation = 0.2;
  options.velocity_deviation = 0.5;
  const auto people = heard.take(
      {{.name = "a", .position = {1, 2}, .velocity = {0.5, -1}, .reliability = 0.8}}, kNow, options);
  ASSERT_EQ(people.size(), 1U);
  EXPECT_EQ(people[0].position, Vector2(1, 2));
  EXPECT_EQ(people[0].velocity, Vector2(0.5, -1));
  EXPECT_DOUBLE_EQ(people[0].radius, 0.4);
  EXPECT_DOUBLE_EQ(people[0].covariance(0, 0), 0.04);
  EXPECT_DOUBLE_EQ(people[0].covariance(3, 3), 0.25);
  EXPECT_DOUBLE_EQ(people[0].covariance(0, 2), 0.0);
  EXPECT_DOUBLE_EQ(people[0].confidence, 0.8);
}

TEST(HeardPeople, LeavesOutWhoIsNowhereOrNotBelieved) {
  HeardPeople heard;
  HeardPeopleOptions options;
  options.min_reliability = 0.5;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto people = heard.take({{.name = "a", .position = {kNan, 0}},
                                  {.name = "b", .velocity = {0, std::numeric_limits<double>::infinity()}},
                                  {.name = "c", .reliability = 0.4},
                                  {.name = "d", .reliability = kNan},
                                  {.name = "e", .reliability = 0.5}},
                                 kNow, options);
  ASSERT_EQ(people.size(), 1U);
  EXPECT_EQ(people[0].id, 1U);
}

}  // namespace
}  // namespace bw::people
