#include "components/messages/tracks.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

using namespace bandwagon_msgs::msg;

/// A quarter turn to the left, and (10, 20): (x, y) becomes (10 - y, 20 + x).
const Pose2 kX_OF{10.0, 20.0, std::numbers::pi / 2.0};

Tracks one_track(double stamp) {
  Track track;
  track.confidence(1.0);
  track.id(7);
  track.radius(0.35);
  track.position(to_point({1.0, 2.0}));
  track.velocity(to_vector3({1.0, 0.0}));
  for (int i = 1; i <= 3; ++i) {
    bandwagon_msgs::msg::PredictedPosition p;
    p.time_from_start().nanosec(static_cast<std::uint32_t>(i) * 300'000'000U);
    p.x(1.0 + 0.6 * i);  // twice as fast as its velocity says
    p.y(2.0);
    p.cov_xx(0.4);
    p.cov_xy(0.1);
    p.cov_yy(0.2);
    track.predictions().push_back(p);
  }
  Tracks tracks;
  tracks.header(make_header("map", Time::seconds(stamp)));
  tracks.tracks().push_back(track);
  return tracks;
}

TEST(TrackMovers, TracksOfNowKeepTheirPlaceAndTurn) {
  const Mover mover = to_movers(one_track(5.0), kX_OF, Time::seconds(5.0)).at(0);
  EXPECT_EQ(mover.id, 7U);
  EXPECT_DOUBLE_EQ(mover.radius, 0.35);
  EXPECT_FALSE(mover.reciprocal);  // a track knows nothing of who avoids whom
  EXPECT_NEAR((mover.position - Vector2(8.0, 21.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((mover.velocity - Vector2(0.0, 1.0)).norm(), 0.0, 1e-12);
  ASSERT_EQ(mover.predictions.size(), 3U);
  EXPECT_NEAR(mover.predictions[2].time, 0.9, 1e-12);
  EXPECT_NEAR((mover.predictions[2].position - Vector2(8.0, 22.8)).norm(), 0.0, 1e-12);
  // A quarter turn swaps the variances and changes the sign between them.
  Eigen::Matrix2d rotated;
  rotated << 0.2, -0.1, -0.1, 0.4;
  EXPECT_NEAR((mover.predictions[2].covariance - rotated).norm(), 0.0, 1e-12);
}

// 0.45 s later it is half way between the first two predictions, at x = 1.9, and of the predictions those at
// 0.6 and 0.9 s are left, 0.15 and 0.45 s ahead.
TEST(TrackMovers, OldTracksMoveAlongTheirPrediction) {
  const Mover mover = to_movers(one_track(5.0), {}, Time::seconds(5.45)).at(0);
  EXPECT_NEAR(mover.position.x(), 1.9, 1e-9);
  ASSERT_EQ(mover.predictions.size(), 2U);
  EXPECT_NEAR(mover.predictions[0].time, 0.15, 1e-9);
  EXPECT_NEAR(mover.predictions[1].time, 0.45, 1e-9);
}

TEST(TrackMovers, WhatDoesNotTellItsConfidenceIsAPerson) {
  for (const auto& [told, taken] :
       {std::pair{0.0, 0.0}, {0.3, 0.3}, {1.0, 1.0}, {std::nan(""), 1.0}, {-0.1, 1.0}, {7.0, 1.0}}) {
    Tracks tracks = one_track(5.0);
    tracks.tracks()[0].confidence(told);
    EXPECT_EQ(to_movers(tracks, {}, Time::seconds(5.0)).at(0).confidence, taken) << told;
    EXPECT_EQ(tells_confidence(tracks.tracks()[0]), told == taken) << told;
  }
}

TEST(TrackMovers, TracksFromTheFutureStay) {
  const Mover mover = to_movers(one_track(6.0), {}, Time::seconds(5.0)).at(0);
  EXPECT_NEAR(mover.position.x(), 1.0, 1e-12);
  EXPECT_EQ(mover.predictions.size(), 3U);
}

TEST(TrackMovers, AreTracksAgain) {
  const std::vector<Mover> movers = to_movers(one_track(5.0), Pose2{}, Time::seconds(5.0));
  EXPECT_EQ(to_message(movers, "map", Time::seconds(5.0)), one_track(5.0));
}

}  // namespace
}  // namespace bw
