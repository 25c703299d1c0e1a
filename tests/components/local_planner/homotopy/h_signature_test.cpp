#include "components/local_planner/homotopy/h_signature.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/local_planner/homotopy/homotopy_options.hpp"
#include "tests/components/local_planner/homotopy/scenes.hpp"

namespace bw::homotopy {
namespace {

const double kThreshold = kHSignatureThreshold;

TEST(HSignature, OfOneObstacleIsItsWinding) {
  // N = 1: A = 1; both sides at mirrored distances: real parts equal, imaginary parts -pi and pi.
  const std::vector<Body> bodies{standing({5.0, 0.0}, 0.3)};
  const auto left = h_signature(route_at_speed({{0, 0}, {5, 1}, {10, 0}}, 1.0), bodies, ten_metres());
  const auto right = h_signature(route_at_speed({{0, 0}, {5, -1}, {10, 0}}, 1.0), bodies, ten_metres());
  EXPECT_NEAR(left.imag(), -std::numbers::pi, 1e-12);
  EXPECT_NEAR(right.imag(), std::numbers::pi, 1e-12);
  EXPECT_NEAR(left.real(), right.real(), 1e-12);
}

TEST(HSignature, AgreesWithWindingAmongUpToSixSeparatedObstacles) {
  // Pairs of random paths: unrelated ones, and copies shaken by up to 0.3 m, so that both verdicts are
  // common.
  Random random(3);
  int same = 0;
  int different = 0;
  for (int trial = 0; trial < 1200; ++trial) {
    std::vector<Body> bodies;
    const auto count = 1 + static_cast<std::size_t>(random.uniform(0.0, 6.0));
    for (const Vector2& p : separated(random, count, 1.0)) bodies.push_back(standing(p, 0.2));
    const auto path = [&] {
      std::vector<Vector2> points{{0.0, 0.0}};
      for (int k = 1; k < 5; ++k) points.push_back({2.0 * k, random.uniform(-2.5, 2.5)});
      points.push_back({10.0, 0.0});
      return points;
    };
    const std::vector<Vector2> first = path();
    std::vector<Vector2> second = path();
    if (trial % 2 == 0) {
      second = first;
      for (std::size_t k = 1; k + 1 < second.size(); ++k) {
        second[k] += Vector2(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
      }
    }
    const Route a = route_at_speed(first, 1.0);
    const Route b = route_at_speed(second, 1.0);
    const Course course = ten_metres();
    const bool by_winding = same_winding(winding(a, bodies, course), winding(b, bodies, course));
    const bool by_signature =
        same_h_signature(h_signature(a, bodies, course), h_signature(b, bodies, course), kThreshold);
    EXPECT_EQ(by_winding, by_signature) << "trial " << trial << " with " << count << " obstacles";
    (by_winding ? same : different) += 1;
  }
  EXPECT_GT(same, 250);
  EXPECT_GT(different, 250);
}

TEST(HSignature, DoesNotUnderflowAmongAHundredObstacles) {
  // Two paths that differ about one of 100: the winding tells which one, the signature does not vanish.
  std::vector<Body> bodies;
  for (int i = 0; i < 10; ++i) {
    for (int k = 0; k < 10; ++k) bodies.push_back(standing({0.5 + i, -4.5 + k}, 0.05));
  }
  const Course course = ten_metres();
  const Route over = route_at_speed({{0, 0}, {4.5, 1.0}, {10, 0}}, 1.0);
  const Route straight = route_at_speed({{0, 0}, {10, 0}}, 1.0);
  const auto windings = windings_between(winding(straight, bodies, course), winding(over, bodies, course));
  // Above the line, below the triangle with its top at (4.5, 1): only rows at y = 0.5 between x = 2.25 and
  // 7.25.
  int differing = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Vector2& c = bodies[b].representative;
    const bool inside = std::abs(c.y() - 0.5) < 1e-9 && c.x() > 2.25 && c.x() < 7.25;
    EXPECT_EQ(windings[b], inside ? 1 : 0);
    differing += inside;
  }
  EXPECT_EQ(differing, 5);
  const auto h = h_signature(over, bodies, course);
  EXPECT_TRUE(std::isfinite(h.real()) && std::isfinite(h.imag()));
  EXPECT_GT(std::abs(h - h_signature(straight, bodies, course)), 1.0);
}

TEST(HSignature, OfCoincidentObstaclesIsFinite) {
  const std::vector<Body> bodies{standing({5.0, 0.0}, 0.3), standing({5.0, 0.0}, 0.3)};
  const auto h = h_signature(route_at_speed({{0, 0}, {5, 0}, {10, 0}}, 1.0), bodies, ten_metres());
  EXPECT_TRUE(std::isfinite(h.real()) && std::isfinite(h.imag()));
  EXPECT_EQ(h_signature({}, {}, ten_metres()), std::complex<double>(0.0, 0.0));
}

}  // namespace
}  // namespace bw::homotopy
