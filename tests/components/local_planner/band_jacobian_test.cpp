// Every analytic Jacobian of the band against numerical differentiation: relative error at most 1e-6 in every
// row.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "components/local_planner/teb/band_evaluation.hpp"
#include "components/model/random.hpp"
#include "tests/components/local_planner/dense_segment.hpp"
#include "tests/components/local_planner/random_band.hpp"

namespace bw::teb {
namespace {

constexpr std::uint64_t kSeed = 51;
constexpr double kBound = 1e-6;
constexpr double kStep = 2e-5;  // [m], [rad], [s]: the sharpest curve, the smoothed sign, bends within 1e-2
constexpr double kSmoothBelow = 1e-7;  // of a row: two steps that agree worse have a kink between them

using Row = std::vector<double>;
using Residuals = std::function<Row(const Row& variables)>;

// d r / d variable i by central differences of fourth order.
Row derivative(const Residuals& residuals, Row variables, std::size_t i, double h) {
  const double at = variables[i];
  const auto moved = [&](double step) {
    variables[i] = at + step;
    return residuals(variables);
  };
  const Row m2 = moved(-2 * h), m1 = moved(-h), p1 = moved(h), p2 = moved(2 * h);
  Row d(m1.size());
  for (std::size_t r = 0; r < d.size(); ++r) d[r] = (m2[r] - 8 * m1[r] + 8 * p1[r] - p2[r]) / (12 * h);
  return d;
}

double largest(const Row& row) {
  double value = 0.0;
  for (const double x : row) value = std::max(value, std::abs(x));
  return value;
}

struct Comparison {
  double worst = 0.0;  // error of an entry over the largest entry of its row
  int rows = 0;        // compared that are not zero
  int kinks = 0;       // left out: numerical differentiation does not agree with itself

  // Analytic rows at `variables`; `visit` gets each row compared.
  void add(
      const Residuals& residuals, const Row& variables, const std::vector<Row>& analytic,
      const std::function<void(std::size_t)>& visit = [](std::size_t) {}) {
    std::vector<Row> coarse, fine;  // by variable
    for (std::size_t i = 0; i < variables.size(); ++i) {
      coarse.push_back(derivative(residuals, variables, i, kStep));
      fine.push_back(derivative(residuals, variables, i, kStep / 2));
    }
    for (std::size_t r = 0; r < analytic.size(); ++r) {
      Row apart, error, numeric;
      for (std::size_t i = 0; i < variables.size(); ++i) {
        numeric.push_back(fine[i][r]);
        apart.push_back(fine[i][r] - coarse[i][r]);
        error.push_back(fine[i][r] - analytic[r][i]);
      }
      const double scale = largest(numeric);
      if (scale == 0.0 && largest(analytic[r]) == 0.0) continue;
      if (largest(apart) > kSmoothBelow * scale) {
        ++kinks;
        continue;
      }
      worst = std::max(worst, largest(error) / scale);
      ++rows;
      visit(r);
    }
  }

  void expect_within_bound() const {
    EXPECT_LE(worst, kBound) << "seed " << kSeed << ", " << rows << " rows";
    EXPECT_LT(kinks, rows / 100) << "seed " << kSeed;
  }
};

Limits tight_limits() {
  Limits limits;
  limits.v_max = 0.4;
  limits.omega_max = 0.3;
  limits.acc_max = limits.alpha_max = 0.5;
  return limits;
}

// Three poses that rotate by up to 3 rad, drive forward and back, slowly and fast.
Row random_states(Random& random) {
  Row s(kSegmentColumns);
  double theta = random.uniform(-3.1, 3.1);
  Vector2 p(0.0, 0.0);
  for (std::size_t pose = 0; pose < 3; ++pose) {
    s[4 * pose] = p.x();
    s[4 * pose + 1] = p.y();
    s[4 * pose + 2] = theta;
    s[4 * pose + 3] = random.uniform(0.1, 0.6);
    p += random.uniform(-0.3, 0.5) * direction(theta) + Vector2(0.0, random.uniform(-0.1, 0.1));
    theta += random.uniform() < 0.5 ? random.uniform(-0.5, 0.5) : random.uniform(-3.0, 3.0);
  }
  return s;
}

TEST(BandJacobian, OfASegmentInBothModelsAtEveryEnd) {
  Random random(kSeed);
  Comparison all;
  std::map<std::tuple<bool, SegmentEnd, std::size_t, bool>, int> sides;  // of the hinges that were met
  for (int i = 0; i < 1500; ++i) {
    const Row variables = random_states(random);
    const Twist2 start{random.uniform(-0.3, 0.6), random.uniform(-0.5, 0.5)};
    BandOptions options;
    options.consistent_motion = i % 2 == 0;
    const SegmentModel model(options, tight_limits());
    for (const SegmentEnd end : {SegmentEnd::next_segment, SegmentEnd::rest, SegmentEnd::free}) {
      for (const bool first : {false, true}) {
        const auto evaluate = [&](const Row& s) {
          const auto segment = dense_segment(model, s.data(), end, first ? &start : nullptr);
          EXPECT_TRUE(segment);
          return segment.value_or(DenseSegment{});
        };
        const DenseSegment at = evaluate(variables);
        std::vector<Row> analytic;
        for (auto row = at.jacobian.begin(); row != at.jacobian.end(); row += kSegmentColumns)
          analytic.emplace_back(row, row + kSegmentColumns);
        all.add(
            [&](const Row& s) {
              const auto r = evaluate(s).residuals;
              return Row(r.begin(), r.end());
            },
            variables, analytic,
            [&](std::size_t r) {
              const Vector2 u = direction(variables[2]);
              const bool angular = r == 4 || r == 6 || r == 8;
              const double slope = angular ? analytic[r][2] : analytic[r][0] * u.x() + analytic[r][1] * u.y();
              ++sides[{options.consistent_motion, end, r, slope > 0.0}];
            });
      }
    }
  }
  all.expect_within_bound();
  RecordProperty("worst_relative_error", std::to_string(all.worst));
  for (const bool consistent : {false, true}) {
    for (const SegmentEnd end : {SegmentEnd::next_segment, SegmentEnd::rest, SegmentEnd::free}) {
      for (std::size_t r = 3; r < kSegmentResiduals; ++r) {
        if (end == SegmentEnd::free && (r == 5 || r == 6)) continue;
        for (const bool side : {false, true})
          EXPECT_GT((sides[{consistent, end, r, side}]), 20)
              << "residual " << r << " too low or too high, never met";
      }
    }
  }
}

// A disc of the size of a point, one of 0.2 m, and a rectangle whose middle is not base_link.
std::vector<Footprint> footprints() {
  return {{0.0, {}}, {0.2, {}}, {0.5, {{-0.1, -0.2}, {0.4, -0.2}, {0.4, 0.2}, {-0.1, 0.2}}}};
}

TEST(BandJacobian, OfClearanceToPointsCapsulesAndMovers) {
  Random random(kSeed);
  Comparison all;
  for (const Footprint& footprint : footprints()) {
    const ClearanceModel model(BandOptions{}, footprint, 2.0);
    int only_inflation = 0, inside = 0;
    for (int i = 0; i < 20000; ++i) {
      const auto point = [&] {
        const double x = random.uniform(-1.0, 1.0);
        return Vector2(x, random.uniform(-1.0, 1.0));
      };
      ClearanceTerm term;
      term.capsule.a = point();
      term.capsule.b = i % 2 == 0 ? term.capsule.a : point();
      term.capsule.radius = i % 5 == 0 ? 0.0 : random.uniform(0.0, 0.5);
      term.moving = i % 3 == 0;
      const Vector2 p = point();
      const Pose2 pose{p.x(), p.y(), random.uniform(-3.0, 3.0)};
      Eigen::Vector3d gradient;
      evaluate_clearance(model, term, pose, &gradient);
      all.add(
          [&](const Row& x) {
            return Row{evaluate_clearance(model, term, {x[0], x[1], x[2]}, nullptr)};
          },
          {pose.x, pose.y, pose.theta}, {{gradient.x(), gradient.y(), gradient.z()}},
          [&](std::size_t) {
            const double distance = gap_to(footprint, pose, term.capsule);
            only_inflation += distance > model.min_dist;
            inside += distance < 0.0;
          });
    }
    EXPECT_GT(only_inflation, 500);
    EXPECT_GT(inside, 500);
  }
  all.expect_within_bound();
}

// The smallest band (one free pose) and longer ones: at rest or in motion at the goal.
TEST(BandJacobian, OfTheWholeCostAsBothSolversSeeIt) {
  Random random(kSeed);
  Comparison all;
  for (int i = 0; i < 300; ++i) {
    RandomBand scene(random, i, footprints()[static_cast<std::size_t>(i) % 3]);
    const BandProblem problem(scene.band, scene.scene, scene.options, 2.0);
    BandEvaluation evaluation(problem);
    ASSERT_TRUE(evaluation.evaluate(scene.band.poses.data()));
    NormalEquations equations;
    evaluation.linearise(equations);
    Row variables, gradient;
    for (std::size_t v = 3; v < 4 * scene.band.size() - 4; ++v) {
      variables.push_back(scene.variable(v));
      gradient.push_back(equations.gradient[v / 4][v % 4]);
    }
    const auto half_cost = [&](const Row& x) {
      Band moved = scene.band;
      for (std::size_t v = 0; v < x.size(); ++v) RandomBand::variable(moved, v + 3) = x[v];
      return Row{problem.cost(moved.poses.data()).total() / 2.0};
    };
    all.add(half_cost, variables, {gradient});
  }
  EXPECT_LE(all.worst, kBound) << "seed " << kSeed;
  EXPECT_GT(all.rows, 200);
}

}  // namespace
}  // namespace bw::teb
