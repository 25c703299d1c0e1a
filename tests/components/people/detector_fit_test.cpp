// Where the detector puts the centre of a leg and of a person, against the discs that were drawn.
#include <cmath>

#include <gtest/gtest.h>

#include "components/people/detector/detector.hpp"
#include "tests/components/people/detector_scan.hpp"

namespace bw::people {
namespace {

struct Errors {
  Vector2 mean{0.0, 0.0};  ///< along the line of sight, and to the left [m]
  double rms = 0.0;        ///< distance [m]
  int count = 0;
};

/// Detections of discs of `radius` at `distance`, in many directions of the beams against the disc. With
/// `hidden`, a pole half way covers that share of the disc from its left edge on.
Errors errors_at(double distance, double radius, double noise, double hidden = 0.0) {
  Scanner scanner(noise, 7);
  Random random(11);
  Errors errors;
  for (int i = 0; i < 400; ++i) {
    const double bearing = random.uniform(-1.5, 1.5);
    const Vector2 sight = direction(bearing);
    const Vector2 left(-sight.y(), sight.x());
    std::vector<Disc> discs = {{distance * sight, radius}};
    if (hidden > 0.0) {
      // The pole's right edge crosses the disc at `edge` left of its middle.
      const double edge = radius * (1.0 - 2.0 * hidden);
      const double half = distance / 2.0;
      discs.push_back({half * sight + (edge / 2.0 + 0.1) * left, 0.1});
    }
    Detector detector(DetectorOptions{});
    const DetectionSet& set = detector.detect(scanner.scan({}, discs, {}, 1.0), {});
    const Detection* nearest = nullptr;
    for (const Detection& d : set.detections) {
      if (d.position.norm() < 0.75 * distance) continue;  // the pole
      if (nearest == nullptr ||
          (d.position - discs[0].center).norm() < (nearest->position - discs[0].center).norm())
        nearest = &d;
    }
    if (nearest == nullptr) continue;
    const Vector2 error = nearest->position - discs[0].center;
    errors.mean += Vector2(sight.dot(error), left.dot(error));
    errors.rms += error.squaredNorm();
    ++errors.count;
  }
  errors.mean /= errors.count;
  errors.rms = std::sqrt(errors.rms / errors.count);
  return errors;
}

TEST(LegPosition, IsUnbiasedWithinTwoCentimetresFromOneToEightMetres) {
  for (const double radius : {0.055, 0.07, 0.09}) {
    for (const double distance : {0.6, 1.0, 2.0, 4.0, 6.0, 8.0}) {
      const Errors errors = errors_at(distance, radius, 0.02);
      ASSERT_GT(errors.count, 350) << distance;
      EXPECT_LT(errors.mean.norm(), 0.02) << "radius " << radius << " at " << distance << " m";
      EXPECT_LT(errors.rms, 0.04) << "radius " << radius << " at " << distance << " m";
      RecordProperty("bias_mm_r" + std::to_string(std::lround(radius * 1000)) + "_at_" +
                         std::to_string(std::lround(distance * 10)) + "dm",
                     static_cast<int>(std::lround(1000.0 * errors.mean.norm())));
    }
  }
}

TEST(LegPosition, ALegHalfHiddenIsStillWhereItIs) {
  for (const double distance : {1.0, 2.0, 4.0}) {
    const Errors errors = errors_at(distance, 0.07, 0.02, 0.5);
    ASSERT_GT(errors.count, 350) << distance;
    EXPECT_LT(errors.mean.norm(), 0.02) << "at " << distance << " m";
  }
}

TEST(LegPosition, OfASurfacePointAloneWouldBeWrongByItsRadius) {
  // What the disc fit is for: the mean of the visible arc lies between r pi / 4 (evenly spread beams) before
  // the centre and r.
  Scanner scanner;
  const std::vector<Disc> leg = {{{2.0, 0.0}, 0.07}};
  Beams beams;
  read_beams(scanner.scan({}, leg, {}, 0.0), beams);
  Vector2 mean{0.0, 0.0};
  int count = 0;
  for (int i = 0; i < beams.size(); ++i) {
    if (beams.kinds[static_cast<std::size_t>(i)] != BeamKind::hit) continue;
    mean += beams.points[static_cast<std::size_t>(i)];
    ++count;
  }
  mean /= count;
  EXPECT_GT(2.0 - mean.x(), 0.05);
  EXPECT_LT(2.0 - mean.x(), 0.07);
}

TEST(LegPosition, HoldsForAScannerOfAnyPose) {
  Scanner still;
  Scanner moved;
  const Pose2 X_OL{12.0, -7.0, 2.1};
  const Vector2 p_L(1.7, 0.4);
  Detector a(DetectorOptions{});
  Detector b(DetectorOptions{});
  const Detection at_origin = a.detect(still.scan({}, {{p_L, 0.07}}, {}, 1.0), {}).detections.at(0);
  const Detection there = b.detect(moved.scan({}, {{X_OL * p_L, 0.07}}, X_OL, 1.0), {}).detections.at(0);
  // Ranges are floats: 1e-7 of 2 m, some more by the fit.
  EXPECT_LT((there.position - X_OL * at_origin.position).norm(), 1e-5);
  EXPECT_NEAR(there.leg_score, at_origin.leg_score, 1e-3);
  EXPECT_NEAR(there.covariance.trace(), at_origin.covariance.trace(), 1e-6);
}

TEST(BodyPosition, TwoLegsThatTouchAreOnePersonBetweenThem) {
  Scanner scanner(0.01, 3);
  Random random(4);
  int bodies = 0;
  double squares = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Vector2 middle = 2.5 * direction(random.uniform(-1.5, 1.5));
    const Vector2 side = 0.072 * direction(random.uniform(-3.1, 3.1));
    Detector detector(DetectorOptions{});
    const DetectionSet& set =
        detector.detect(scanner.scan({}, {{middle + side, 0.07}, {middle - side, 0.07}}, {}, 1.0), {});
    for (const Detection& d : set.detections) {
      if (d.body_score < 0.5) continue;
      ++bodies;
      squares += (d.position - middle).squaredNorm();
    }
  }
  EXPECT_GT(bodies, 60);
  EXPECT_LT(std::sqrt(squares / bodies), 0.05);
  RecordProperty("bodies", bodies);
  RecordProperty("rms_mm", static_cast<int>(std::lround(1000.0 * std::sqrt(squares / bodies))));
}

}  // namespace
}  // namespace bw::people
