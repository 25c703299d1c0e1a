// Figures by hand: root mean squares of a few errors, with the truth carried along its arc.
#include "components/evaluation/pose_errors.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

TruthSample truth(double seconds, const Pose2& X_MB, const Twist2& twist = {}) {
  return {.time = Time{} + Duration::seconds(seconds), .X_MB = X_MB, .twist = twist};
}
Time after_start(double seconds) { return Time{} + Duration::seconds(seconds); }

TEST(PoseErrors, SumsUpSquaresAndTheWorst) {
  PoseErrors errors;
  errors.set_truth(truth(1.0, {1.0, 2.0, 3.1}));
  errors.add(after_start(1.0), {1.3, 2.4, -3.1});  // 0.5 m; 2 pi - 6.2 rad across the wrap
  errors.add(after_start(1.0), {1.0, 2.0, 3.1});
  EXPECT_EQ(errors.count(), 2);
  EXPECT_NEAR(errors.mean_position(), 0.25, 1e-12);
  EXPECT_NEAR(errors.rms_position(), 0.5 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(errors.rms_heading(), (2.0 * std::numbers::pi - 6.2) / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(errors.max_position(), 0.5, 1e-12);
}

// 1 m/s at 1 rad/s for 0.1 s: the arc of radius 1 m ends at (sin 0.1, 1 - cos 0.1, 0.1).
TEST(PoseErrors, CarriesTheTruthToTheStampOfTheEstimate) {
  PoseErrors errors;
  errors.set_truth(truth(5.0, {}, {1.0, 1.0}));
  errors.add(after_start(5.1), {std::sin(0.1), 1.0 - std::cos(0.1), 0.1});
  EXPECT_NEAR(errors.rms_position(), 0.0, 1e-12);
  EXPECT_NEAR(errors.rms_heading(), 0.0, 1e-12);
}

// A reference of positions alone, 0.2 s apart: half way from (0, 0) to (1, 0) lies (0.5, 0), however early
// the estimate comes.
TEST(PoseErrors, InterpolatesATruthWithoutSpeedAndHeading) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto position = [](double seconds, double x) { return truth(seconds, {x, 0.0, kNan}, {kNan, kNan}); };
  PoseErrors errors;
  errors.set_truth(position(1.0, 0.0));
  errors.add(after_start(1.0), {0.0, 0.1, 3.0});  // at its moment
  errors.add(after_start(1.1), {0.5, 0.3, 3.0});  // waits
  errors.add(after_start(1.2), {1.0, 0.2, 3.0});  // waits for its moment
  EXPECT_EQ(errors.count(), 1);
  errors.set_truth(position(1.2, 1.0));
  EXPECT_EQ(errors.count(), 3);
  errors.add(after_start(1.15), {0.75, 0.4, 3.0});  // late
  EXPECT_EQ(errors.count(), 4);
  EXPECT_NEAR(errors.mean_position(), 0.25, 1e-12);
  EXPECT_NEAR(errors.max_position(), 0.4, 1e-12);
  EXPECT_TRUE(std::isnan(errors.rms_heading()));
  errors.add(after_start(1.5), {0.0, 0.0, 0.0});
  errors.set_truth(position(1.8, 9.0));  // 0.6 s without a word
  EXPECT_EQ(errors.count(), 4);
  errors.set_truth(truth(2.0, {9.0, 0.0, 0.5}, {1.0, 0.0}));  // speed and heading from here on
  errors.add(after_start(2.0), {9.0, 0.0, 0.75});
  EXPECT_NEAR(errors.rms_heading(), 0.25, 1e-12);
}

TEST(PoseErrors, LeavesOutWhatCannotBeCompared) {
  PoseErrors errors;
  errors.add(after_start(0.0), {});  // no truth yet
  errors.set_truth(truth(5.0, {}));
  errors.add(after_start(5.3), {});
  errors.add(after_start(4.7), {});
  errors.add(after_start(5.0), {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  EXPECT_EQ(errors.count(), 0);
  EXPECT_TRUE(std::isnan(errors.mean_position()));
  EXPECT_TRUE(std::isnan(errors.rms_position()));
  EXPECT_TRUE(std::isnan(errors.max_position()));
}

}  // namespace
}  // namespace bw
