// One request, one reply, whatever comes between.
#include "components/robot_base/eddie/dialogue.hpp"

#include <string_view>

#include <gtest/gtest.h>

#include "tests/components/robot_base/scripted_link.hpp"

namespace bw::eddie {
namespace {

class EddieDialogue : public testing::Test {
 protected:
  std::optional<Reply> at(int milliseconds, std::string_view text) {
    return dialogue_.take(Time{} + Duration::milliseconds(milliseconds), bytes_of(text));
  }
  bool is_free(int milliseconds) const {
    return dialogue_.is_free(Time{} + Duration::milliseconds(milliseconds));
  }
  void ask(int milliseconds) {
    ASSERT_TRUE(is_free(milliseconds));
    ASSERT_TRUE(
        dialogue_.ask(Time{} + Duration::milliseconds(milliseconds), Request::counts, "DIST\r", link_));
  }

  ScriptedLink::Wire wire_;
  ScriptedLink link_{wire_};
  Dialogue dialogue_{Duration::milliseconds(80)};
};

TEST_F(EddieDialogue, AReplyMayComeInPieces) {
  ask(0);
  EXPECT_FALSE(is_free(5));
  EXPECT_FALSE(at(10, "000000FF 000"));
  EXPECT_FALSE(at(20, "00000"));
  const auto reply = at(30, "\r");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->text, "000000FF 00000000");
  EXPECT_EQ(reply->request, Request::counts);
  EXPECT_EQ(reply->arrived, Time{} + Duration::milliseconds(30));
  EXPECT_TRUE(is_free(30));
}

TEST_F(EddieDialogue, WhatIsLateIsNotTakenForTheNextReply) {
  ask(0);
  EXPECT_FALSE(at(79, ""));
  const auto reply = at(80, "");
  ASSERT_TRUE(reply);
  EXPECT_TRUE(reply->is_timeout);
  EXPECT_FALSE(is_free(100));
  EXPECT_FALSE(at(105, "00000001 00000001\r"));  // late
  EXPECT_FALSE(is_free(134));
  EXPECT_TRUE(is_free(135));
  ask(135);
  EXPECT_EQ(at(140, "00000002 00000002\r")->text, "00000002 00000002");
  EXPECT_EQ(dialogue_.counts().timeouts, 1U);
}

TEST_F(EddieDialogue, HalfALineIsGivenUpWithItsTime) {
  ask(0);
  EXPECT_FALSE(at(10, "000000"));
  EXPECT_TRUE(at(80, "")->is_timeout);
  EXPECT_EQ(dialogue_.counts().bytes_thrown_away, 6U);
  ask(120);
  EXPECT_EQ(at(130, "X\r")->text, "X");
}

TEST_F(EddieDialogue, ALineThatNobodyAskedForIsCounted) {
  EXPECT_FALSE(at(0, "Eddie ready\r"));
  EXPECT_EQ(dialogue_.counts().unexpected_lines, 1U);
  EXPECT_FALSE(is_free(20));
  ask(40);
  EXPECT_EQ(at(50, "A\rB\r")->text, "A");
  EXPECT_EQ(dialogue_.counts().unexpected_lines, 2U);
}

TEST_F(EddieDialogue, ALineWithBytesThatAreNoTextIsNone) {
  ask(0);
  EXPECT_FALSE(at(10,
                  "0000\x80"
                  "0FF 00000000\r"));
  EXPECT_EQ(at(20, "000000FF 00000000\r")->text, "000000FF 00000000");
}

TEST_F(EddieDialogue, ALineIsNotLongerThanTheBoardsBuffer) {
  ask(0);
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(at(i, "0123456789"));
  EXPECT_FALSE(at(50, "\r"));
  EXPECT_EQ(dialogue_.counts().bytes_thrown_away, 500U);
}

TEST_F(EddieDialogue, NothingIsAskedOfACableThatTakesNothing) {
  wire_.refuses = true;
  EXPECT_FALSE(dialogue_.ask(Time{}, Request::counts, "DIST\r", link_));
  EXPECT_TRUE(is_free(0));
}

}  // namespace
}  // namespace bw::eddie
