// IMU, GPS and the random streams.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/world/gps.hpp"
#include "components/world/imu.hpp"
#include "components/world/random_streams.hpp"

namespace bw {
namespace {

TEST(Imu, ReadsTruthPlusBiasAndNoise) {
  ImuOptions options;
  options.gyro_bias = 0.02;
  options.gyro_noise = 0.01;
  options.heading_bias = -0.1;
  options.heading_noise = 0.05;
  Imu imu(options, Random(3));
  constexpr int kReadings = 20000;
  double rate_sum = 0.0;
  double rate_squares = 0.0;
  double heading_sum = 0.0;
  double heading_squares = 0.0;
  for (int i = 0; i < kReadings; ++i) {
    const ImuReading reading = imu.read({0.0, 0.0, 3.1}, {1.0, 0.5});
    const double rate_error = reading.turn_rate - 0.52;
    const double heading_error = wrap_angle(reading.heading - 3.0);
    ASSERT_LE(std::abs(reading.heading), std::numbers::pi);
    rate_sum += rate_error;
    rate_squares += rate_error * rate_error;
    heading_sum += heading_error;
    heading_squares += heading_error * heading_error;
  }
  // Five standard errors of mean and standard deviation.
  EXPECT_NEAR(rate_sum / kReadings, 0.0, 5.0 * 0.01 / std::sqrt(kReadings));
  EXPECT_NEAR(std::sqrt(rate_squares / kReadings), 0.01, 5.0 * 0.01 / std::sqrt(2.0 * kReadings));
  EXPECT_NEAR(heading_sum / kReadings, 0.0, 5.0 * 0.05 / std::sqrt(kReadings));
  EXPECT_NEAR(std::sqrt(heading_squares / kReadings), 0.05, 5.0 * 0.05 / std::sqrt(2.0 * kReadings));
}

TEST(Gps, FixesArriveLateInOrderAndOnce) {
  GpsOptions options;
  options.noise = 0.0;
  options.latency = 0.5;
  Gps gps(options, Random(1));
  gps.measure(Duration::seconds(1.0), {1.0, 0.0});
  gps.measure(Duration::seconds(1.2), {2.0, 0.0});
  EXPECT_TRUE(gps.arrived(Duration::seconds(1.49)).empty());
  const auto first = gps.arrived(Duration::seconds(1.5));
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].measured_at, Duration::seconds(1.0));
  EXPECT_EQ(first[0].position, Vector2(1.0, 0.0));
  EXPECT_EQ(gps.arrived(Duration::seconds(3.0)).size(), 1u);
  EXPECT_TRUE(gps.arrived(Duration::seconds(9.0)).empty());
}

TEST(Gps, HasNoFixUnderARoof) {
  GpsOptions options;
  options.outage_zones = {{10.0, -5.0, 20.0, 5.0}};
  Gps gps(options, Random(1));
  for (const double x : {9.9, 10.1, 19.9, 20.1}) gps.measure({}, {x, 0.0});
  const auto fixes = gps.arrived({});
  ASSERT_EQ(fixes.size(), 4u);
  EXPECT_TRUE(fixes[0].valid);
  EXPECT_FALSE(fixes[1].valid);
  EXPECT_FALSE(fixes[2].valid);
  EXPECT_TRUE(fixes[3].valid);
}

TEST(Gps, PlacesTheDatumOnTheEarth) {
  // WGS 84 tables: one degree of latitude is 110.574 km at the equator and 111.132 km at 45 deg; one degree
  // of longitude 111.320 km and 78.847 km.
  EXPECT_NEAR(to_latitude_longitude({0.0, 110574.0}, 0.0, 10.0).x(), 1.0, 1e-5);
  EXPECT_NEAR(to_latitude_longitude({111320.0, 0.0}, 0.0, 10.0).y(), 11.0, 1e-5);
  EXPECT_NEAR(to_latitude_longitude({0.0, 1111.32}, 45.0, 10.0).x(), 45.01, 1e-6);
  EXPECT_NEAR(to_latitude_longitude({788.47, 0.0}, 45.0, 10.0).y(), 10.01, 1e-6);
}

TEST(RandomStream, EveryPurposeAndSeedIsItsOwn) {
  const auto first = [](std::uint64_t seed, RandomPurpose purpose) {
    return random_stream(seed, purpose).bits();
  };
  EXPECT_EQ(first(7, RandomPurpose::laser), first(7, RandomPurpose::laser));
  EXPECT_NE(first(7, RandomPurpose::laser), first(7, RandomPurpose::imu));
  EXPECT_NE(first(7, RandomPurpose::laser), first(8, RandomPurpose::laser));
  EXPECT_NE(first(7, RandomPurpose::laser), first(8, RandomPurpose::wheels));
}

}  // namespace
}  // namespace bw
