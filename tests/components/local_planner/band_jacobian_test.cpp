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

#include "components/local_planner/teb/band_functions.hpp"
#include "components/model/random.hpp"

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

// Three poses that turn by up to 3 rad, drive forward and back, slowly and fast.
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
        const auto evaluate = [&](const Row& s, double* jacobian) {
          Row r(kSegmentResiduals);
          const double* c = end == SegmentEnd::next_segment ? &s[8] : nullptr;
          EXPECT_TRUE(
              evaluate_segment(model, {&s[0], &s[4], c, end, first ? &start : nullptr}, r.data(), jacobian));
          return r;
        };
        Row J(kSegmentResiduals * kSegmentColumns);
        evaluate(variables, J.data());
        std::vector<Row> analytic;
        for (auto row = J.begin(); row != J.end(); row += kSegmentColumns)
          analytic.emplace_back(row, row + kSegmentColumns);
        all.add([&](const Row& s) { return evaluate(s, nullptr); }, variables, analytic,
                [&](std::size_t r) {
                  const Vector2 u = direction(variables[2]);
                  const bool angular = r == 4 || r == 6 || r == 8;
                  const double slope =
                      angular ? analytic[r][2] : analytic[r][0] * u.x() + analytic[r][1] * u.y();
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

TEST(BandJacobian, OfClearanceToPointsCapsulesAndMovers) {
  Random random(kSeed);
  const ClearanceModel model(BandOptions{}, 2.0);
  Comparison all;
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
    Vector2 gradient;
    evaluate_clearance(model, term, p, &gradient);
    all.add(
        [&](const Row& x) {
          return Row{evaluate_clearance(model, term, {x[0], x[1]}, nullptr)};
        },
        {p.x(), p.y()}, {{gradient.x(), gradient.y()}},
        [&](std::size_t) {
          const double distance = clearance_to(term.capsule, p).distance;
          only_inflation += distance > model.min_dist;
          inside += distance < 0.0;
        });
  }
  all.expect_within_bound();
  EXPECT_GT(only_inflation, 500);
  EXPECT_GT(inside, 500);
}

// All free variables of a band in a row, and the function's blocks among them.
std::vector<std::vector<double*>> blocks_of(Band& band, std::size_t first, std::size_t last) {
  std::vector<std::vector<double*>> blocks;
  for (std::size_t k = first; k <= last && k + 1 < band.size(); ++k) {
    BandPose& p = band.poses[k];
    blocks.push_back(k == 0 ? std::vector<double*>{&p.dt}
                            : std::vector<double*>{&p.x, &p.y, &p.theta, &p.dt});
  }
  return blocks;
}

void compare(const ceres::CostFunction& function, const std::vector<std::vector<double*>>& blocks,
             Comparison& all) {
  Row variables;
  for (const auto& block : blocks) {
    for (const double* x : block) variables.push_back(*x);
  }
  ASSERT_EQ(function.parameter_block_sizes().size(), blocks.size());
  const auto rows = static_cast<std::size_t>(function.num_residuals());
  const auto evaluate = [&](const Row& x, std::vector<Row>* jacobians) {
    std::vector<const double*> parameters;
    std::vector<double*> out;
    std::size_t offset = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      EXPECT_EQ(static_cast<std::size_t>(function.parameter_block_sizes()[b]), blocks[b].size());
      parameters.push_back(&x[offset]);
      if (jacobians != nullptr) out.push_back(jacobians->emplace_back(rows * blocks[b].size()).data());
      offset += blocks[b].size();
    }
    Row r(rows);
    EXPECT_TRUE(function.Evaluate(parameters.data(), r.data(), jacobians == nullptr ? nullptr : out.data()));
    return r;
  };
  std::vector<Row> jacobians;
  jacobians.reserve(blocks.size());
  evaluate(variables, &jacobians);
  std::vector<Row> analytic(rows);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto size = static_cast<std::ptrdiff_t>(blocks[b].size());
    for (std::size_t r = 0; r < rows; ++r) {
      const auto first = jacobians[b].begin() + static_cast<std::ptrdiff_t>(r) * size;
      analytic[r].insert(analytic[r].end(), first, first + size);
    }
  }
  all.add([&](const Row& x) { return evaluate(x, nullptr); }, variables, analytic);
}

// The smallest band (one free pose) and longer ones: both ends fixed, at rest or in motion at the goal.
TEST(BandJacobian, OfTheCostFunctionsThatCeresSees) {
  Random random(kSeed);
  Comparison segments, at_poses, along_segments;
  for (int i = 0; i < 150; ++i) {
    Band band;
    const std::size_t count = 3 + static_cast<std::size_t>(i % 4);
    for (std::size_t k = 0; k < count; ++k) {
      const double x = 0.35 * static_cast<double>(k) + random.uniform(-0.1, 0.1);
      const double y = random.uniform(-0.2, 0.2), theta = random.uniform(-0.8, 0.8);
      band.poses.push_back({x, y, theta, random.uniform(0.1, 0.6)});
    }
    ObstacleField field;
    for (int j = 0; j < 6; ++j) {
      const Vector2 a(random.uniform(0.0, 1.5), random.uniform(-0.6, 0.6));
      const Vector2 b = j % 2 == 0 ? a : Vector2(a + Vector2(0.3, random.uniform(-0.3, 0.3)));
      field.statics.push_back({a, b, random.uniform(0.0, 0.2)});
      Mover mover;
      mover.position = {random.uniform(0.0, 1.5), random.uniform(-1.0, 1.0)};
      mover.velocity = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
      field.movers.push_back(mover);
    }
    BandOptions options;
    options.consistent_motion = i % 2 == 0;
    options.clearance_step = 0.1;
    const BandScene scene{
        tight_limits(), {random.uniform(-0.2, 0.5), random.uniform(-0.3, 0.3)}, i % 3 != 0, &field};
    const BandProblem problem(band, scene, options, 2.0);
    for (std::size_t k = 0; k < problem.segments(); ++k) {
      compare(SegmentFunction(problem, k), blocks_of(band, k, k + 2), segments);
      const std::size_t first = std::max<std::size_t>(k, 1);  // a place of the start is not free
      if (!problem.terms[k].at_pose.empty())
        compare(ClearanceFunction(problem, k, false), blocks_of(band, first, k), at_poses);
      if (!problem.terms[k].along_segment.empty())
        compare(ClearanceFunction(problem, k, true), blocks_of(band, first, k + 1), along_segments);
    }
  }
  segments.expect_within_bound();
  at_poses.expect_within_bound();
  along_segments.expect_within_bound();
  EXPECT_GT(segments.rows, 2000);
  EXPECT_GT(at_poses.rows, 1000);
  EXPECT_GT(along_segments.rows, 1000);
}

}  // namespace
}  // namespace bw::teb
