#include "components/model/local_plane.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::localization {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kSemiMajor = 6378137.0;
constexpr double kSemiMinor = 6356752.314245;  // printed in the definition of WGS 84, rounded to 1e-6 m

// A second way to the same point: the ellipse by its reduced latitude, tan(beta) = b / a tan(latitude), with
// neither eccentricity nor prime vertical radius.
Eigen::Vector3d by_reduced_latitude(double latitude, double longitude) {
  const double beta = std::atan(kSemiMinor / kSemiMajor * std::tan(latitude * kDegree));
  const double r = kSemiMajor * std::cos(beta);
  return {r * std::cos(longitude * kDegree), r * std::sin(longitude * kDegree), kSemiMinor * std::sin(beta)};
}

LocalPlane plane(double latitude, double longitude, double altitude = 0.0) {
  return *LocalPlane::around({latitude, longitude, altitude});
}

TEST(LocalPlane, EarthCentredMatchesTheReducedLatitude) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double latitude = random.uniform(-89.9, 89.9);
    const double longitude = random.uniform(-180.0, 180.0);
    const Eigen::Vector3d ours = to_earth_centred({latitude, longitude, 0.0});
    ASSERT_LT((ours - by_reduced_latitude(latitude, longitude)).norm(), 2e-6) << latitude;
  }
}

// On the equator the section of the ellipsoid is a circle of radius a: (a sin, 0, a (cos - 1)).
TEST(LocalPlane, TheEquatorIsACircle) {
  for (const double longitude : {-1.0, 0.001, 0.1, 30.0}) {
    const Eigen::Vector3d p = plane(0.0, 10.0).to_plane({0.0, 10.0 + longitude, 0.0});
    EXPECT_NEAR(p.x(), kSemiMajor * std::sin(longitude * kDegree), 1e-6);
    EXPECT_NEAR(p.y(), 0.0, 1e-6);
    EXPECT_NEAR(p.z(), kSemiMajor * (std::cos(longitude * kDegree) - 1.0), 1e-6);
  }
}

// At the north pole with datum longitude 0, east is y of the earth and north is -x.
TEST(LocalPlane, ThePoleHasItsAxes) {
  const Eigen::Vector3d p = plane(90.0, 0.0).to_plane({89.0, 90.0, 0.0});
  const Eigen::Vector3d earth = by_reduced_latitude(89.0, 90.0);
  EXPECT_NEAR(p.x(), earth.y(), 1e-5);
  EXPECT_NEAR(p.y(), 0.0, 1e-5);
  EXPECT_NEAR(p.z(), earth.z() - kSemiMinor, 1e-5);
}

// One degree of latitude about 45 deg is 111,131.7 m, one of longitude 78,846.8 m (printed tables of the
// lengths of degrees). Short of that by the bend: chord / arc = 1 - (1 deg)^2 / 24 within 1.5 m.
TEST(LocalPlane, DegreesAt45HaveTheirPrintedLengths) {
  const LocalPlane p = plane(45.0, 0.0);
  const double north = p.to_plane({45.5, 0.0, 0.0}).y() - p.to_plane({44.5, 0.0, 0.0}).y();
  EXPECT_NEAR(north, 111131.7, 2.0);
  EXPECT_NEAR(p.to_plane({45.0, 0.5, 0.0}).x() - p.to_plane({45.0, -0.5, 0.0}).x(), 78846.8, 2.0);
}

TEST(LocalPlane, UpIsAltitude) {
  const Eigen::Vector3d p = plane(21.0, 105.8, 10.0).to_plane({21.0, 105.8, 35.0});
  EXPECT_NEAR(p.x(), 0.0, 1e-8);
  EXPECT_NEAR(p.y(), 0.0, 1e-8);
  EXPECT_NEAR(p.z(), 25.0, 1e-8);
}

TEST(LocalPlane, ThereAndBackWithinAMicrometre) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const LocalPlane p =
        plane(random.uniform(-90.0, 90.0), random.uniform(-180.0, 180.0), random.uniform(-100.0, 3000.0));
    const double reach = std::pow(10.0, random.uniform(0.0, 6.0));
    const Eigen::Vector3d position(random.uniform(-reach, reach), random.uniform(-reach, reach),
                                   random.uniform(-1000.0, 1000.0));
    ASSERT_LT((p.to_plane(p.to_geodetic(position)) - position).norm(), 1e-6) << i;
  }
}

TEST(LocalPlane, CrossesTheDateLine) {
  EXPECT_NEAR(plane(0.0, 179.9999).to_plane({0.0, -179.9999, 0.0}).x(),
              kSemiMajor * std::sin(0.0002 * kDegree), 1e-6);
}

TEST(LocalPlane, RefusesWhatIsNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(LocalPlane::around({nan, 0.0, 0.0}));
  EXPECT_FALSE(LocalPlane::around({0.0, nan, 0.0}));
  EXPECT_FALSE(LocalPlane::around({0.0, 0.0, nan}));
  EXPECT_FALSE(LocalPlane::around({90.1, 0.0, 0.0}));
  EXPECT_FALSE(LocalPlane::around({0.0, 361.0, 0.0}));
  EXPECT_FALSE(LocalPlane::around({0.0, 0.0, 1e9}));
}

}  // namespace
}  // namespace bw::localization
