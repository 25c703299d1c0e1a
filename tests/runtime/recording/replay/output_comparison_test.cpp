#include "runtime/recording/replay/output_comparison.hpp"

#include <gmock/gmock.h>

#include "tests/runtime/recording/replay/messages.hpp"

namespace bw::replay {
namespace {

using ::testing::IsEmpty;

const std::string kTopic = "/cmd_vel";
const std::string kType = "geometry_msgs/msg/TwistStamped";

Time at(double seconds) { return Time::seconds(seconds); }

class Comparison {
 public:
  explicit Comparison(Pairing pairing, Tolerances tolerances = {}) : outputs(pairing, std::move(tolerances)) {
    outputs.add_topic(kTopic, kType);
  }
  void recorded(double t, double x, double z = 0.0) { outputs.expect(kTopic, at(t), twist(t, x, z)); }
  void replayed(double t, double x, double z = 0.0) { outputs.got(kTopic, at(t), twist(t, x, z)); }
  const TopicVerdict& verdict(double end = 100.0) {
    outputs.finish(at(end));
    return outputs.verdicts().at(kTopic);
  }
  OutputComparison outputs;
};

TEST(OutputComparison, InOrderBytesAndTimesCount) {
  Comparison c(Pairing::in_order);
  for (const double t : {1.0, 1.1, 1.2}) c.recorded(t, t);
  c.replayed(1.0, 1.0);
  c.replayed(1.1, 1.25);
  c.outputs.got(kTopic, at(1.21), twist(1.2, 1.2));  // the same bytes, 10 ms late
  const TopicVerdict& verdict = c.verdict();
  EXPECT_EQ(verdict.equal, 1U);
  EXPECT_EQ(verdict.differing, 2U);
  EXPECT_NEAR(verdict.largest, 0.15, 1e-12);
  EXPECT_EQ(verdict.largest_field, "twist.linear.x");
  ASSERT_TRUE(verdict.first);
  EXPECT_EQ(verdict.first->field, "twist.linear.x");
  EXPECT_EQ(verdict.first->recorded, "1.1");
  EXPECT_EQ(verdict.first->replayed, "1.25");
  EXPECT_EQ(verdict.first->time, at(1.1));
  EXPECT_EQ(c.outputs.first_topic(), kTopic);
}

// -0 and 0 are equal numbers and other bytes.
TEST(OutputComparison, AnotherZeroIsAnotherByte) {
  Comparison c(Pairing::in_order);
  c.recorded(1.0, 0.0);
  c.replayed(1.0, -0.0);
  EXPECT_EQ(c.verdict().differing, 1U);
  EXPECT_EQ(c.verdict().first->field, "bytes");
}

TEST(OutputComparison, WhatIsMissingOrTooMuchIsCounted) {
  Comparison missing(Pairing::in_order);
  missing.recorded(1.0, 0.0);
  EXPECT_EQ(missing.verdict().missing, 1U);
  EXPECT_EQ(missing.verdict().first->replayed, "none");
  Comparison extra(Pairing::in_order);
  extra.replayed(1.0, 0.0);
  extra.replayed(5.0, 0.0);  // the recording ends here: it may have stopped before this message
  EXPECT_EQ(extra.verdict(5.0).extra, 1U);
}

TEST(OutputComparison, TolerancesHoldPerField) {
  const Tolerances tolerances = {
      {kTopic, {.absolute = {{"twist.linear", 0.1}}, .left_out = {"twist.angular"}}}};
  Comparison c(Pairing::in_order, tolerances);
  c.recorded(1.0, 1.0, 0.0);
  c.replayed(1.0, 1.09, 55.0);
  c.recorded(1.1, 1.0, 0.0);
  c.replayed(1.1, 1.11, 0.0);
  const TopicVerdict& verdict = c.verdict();
  EXPECT_EQ(verdict.equal, 1U);
  EXPECT_EQ(verdict.differing, 1U);
  EXPECT_NEAR(verdict.largest, 0.11, 1e-12) << "what is left out is not in it";
}

// 10 Hz, the new ones 20 ms later throughout, the second is not written now and one comes between: pairs 1, 3
// and 4.
TEST(OutputComparison, ByStampTheNearestBelongTogether) {
  Comparison c(Pairing::by_stamp);
  for (const double t : {1.0, 1.1, 1.2, 1.3}) c.recorded(t, t);
  c.replayed(1.02, 1.0);
  c.replayed(1.22, 1.2);
  c.replayed(1.27, 7.0);
  c.replayed(1.32, 1.3);
  const TopicVerdict& verdict = c.verdict();
  EXPECT_EQ(verdict.equal, 3U);
  EXPECT_EQ(verdict.differing, 0U);
  EXPECT_EQ(verdict.missing, 1U);
  EXPECT_EQ(verdict.extra, 1U);
  EXPECT_NEAR(verdict.apart, 0.02, 1e-9);
  EXPECT_EQ(verdict.first->time, at(1.1));
}

// The writer ran from 1.0 s to 1.3 s; the new one runs from 0 s to 2 s.
TEST(OutputComparison, ByStampOnlyTheTimeOfTheWriterCounts) {
  Comparison c(Pairing::by_stamp);
  for (const double t : {1.0, 1.1, 1.2, 1.3}) c.recorded(t, 1.0);
  for (int i = 0; i <= 20; ++i) c.replayed(0.1 * i, 1.0);
  const TopicVerdict& verdict = c.verdict();
  EXPECT_EQ(verdict.equal, 4U);
  EXPECT_EQ(verdict.extra, 0U);
  EXPECT_TRUE(verdict.is_equal());
}

TEST(OutputComparison, TheHashIsOfWhatIsWrittenNow) {
  const auto hash = [](double recorded, double replayed) {
    Comparison c(Pairing::in_order);
    c.recorded(1.0, recorded);
    c.replayed(1.0, replayed);
    return c.outputs.sha256();
  };
  EXPECT_EQ(hash(1.0, 2.0), hash(2.0, 2.0));
  EXPECT_NE(hash(2.0, 1.0), hash(2.0, 2.0));
}

TEST(OutputComparison, NothingAtAllIsNoDifference) {
  Comparison c(Pairing::by_stamp);
  EXPECT_TRUE(c.verdict().is_equal());
  EXPECT_EQ(c.outputs.compared(), 0U);
  EXPECT_FALSE(c.outputs.first_topic());
}

}  // namespace
}  // namespace bw::replay
