#include "runtime/recording/replay/reordered_messages.hpp"

#include <string>

#include <gtest/gtest.h>

namespace bw::replay {
namespace {

/// Messages 0 to 5 of one byte each, their number, at 0, 10, ... 50 ns; damage stands behind the third.
class Six final : public bag::BagMessages {
 public:
  bag::Step next(bag::BagMessage& message) override {
    if (next_ == 3 && !is_told_) {
      is_told_ = true;
      return bag::Step::damaged;
    }
    if (next_ == 6) return bag::Step::end;
    byte_ = {static_cast<std::uint8_t>(next_)};
    message = {.topic = 0, .log_time = {next_ * 10}, .publish_time = {next_ * 10}, .data = byte_};
    ++next_;
    return bag::Step::message;
  }
  [[nodiscard]] bag::BagFault fault() const override { return {.file = {}, .offset = 7, .what = {}}; }

 private:
  std::int64_t next_ = 0;
  bool is_told_ = false;
  bag::Bytes byte_;
};

/// "0@0 1@10 ! ...": bytes and log times, ! for damage.
std::string order_with(std::vector<Delay> delays) {
  const auto messages = reordered(std::make_unique<Six>(), std::move(delays));
  std::string text;
  bag::BagMessage message;
  for (bag::Step step; (step = messages->next(message)) != bag::Step::end;) {
    text += step == bag::Step::damaged
                ? std::string("! ")
                : std::to_string(message.data[0]) + "@" + std::to_string(message.log_time.nanoseconds) + " ";
  }
  return text;
}

TEST(ReorderedMessages, WithoutDelaysAreAsTheyWere) {
  EXPECT_EQ(order_with({}), "0@0 1@10 2@20 ! 3@30 4@40 5@50 ");
}

TEST(ReorderedMessages, ADelayedOneComesBehindItsOtherAtItsTime) {
  EXPECT_EQ(order_with({{1, 4}}), "0@0 2@20 ! 3@30 4@40 1@40 5@50 ");
  EXPECT_EQ(order_with({{0, 5}}), "1@10 2@20 ! 3@30 4@40 5@50 0@50 ");
}

TEST(ReorderedMessages, SeveralBehindOneKeepTheirOrder) {
  EXPECT_EQ(order_with({{1, 3}, {2, 3}}), "0@0 ! 3@30 1@30 2@30 4@40 5@50 ");
}

TEST(ReorderedMessages, WhatIsBehindADelayedOneComesWithIt) {
  EXPECT_EQ(order_with({{1, 4}, {0, 1}}), "2@20 ! 3@30 4@40 1@40 0@40 5@50 ");
}

}  // namespace
}  // namespace bw::replay
