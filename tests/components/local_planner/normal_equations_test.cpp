// The banded normal equations and their factorisation against dense ones.
#include "components/local_planner/teb/normal_equations.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "components/local_planner/teb/band_evaluation.hpp"
#include "tests/components/local_planner/dense_segment.hpp"
#include "tests/components/local_planner/random_band.hpp"

namespace bw::teb {
namespace {

using Eigen::Index;

constexpr std::uint64_t kSeed = 57;
const Footprint kRectangle{0.5, {{-0.1, -0.2}, {0.4, -0.2}, {0.4, 0.2}, {-0.1, 0.2}}};

// From variables 3 (dt of the start) to the last dt: those that are free.
Index free_count(const Band& band) { return 4 * static_cast<Index>(band.size()) - 7; }

Eigen::VectorXd free_part(const BandVector& vector, Index count) {
  Eigen::VectorXd part(count);
  for (Index v = 0; v < count; ++v) {
    part[v] = vector[static_cast<std::size_t>(v + 3) / 4][static_cast<std::size_t>(v + 3) % 4];
  }
  return part;
}

Eigen::MatrixXd dense(const NormalEquations& equations, Index count) {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(count, count);
  for (Index i = 0; i < count; ++i) {
    const auto block = static_cast<std::size_t>(i + 3) / 4;
    for (Index j = i; j < std::min<Index>(count, 4 * static_cast<Index>(block) + 9); ++j) {
      const auto column = static_cast<std::size_t>(j + 3) - 4 * block;
      H(i, j) = H(j, i) = equations.rows[block][static_cast<std::size_t>(i + 3) % 4][column];
    }
  }
  return H;
}

// J'J of every term, each over all poses.
Eigen::MatrixXd term_by_term(RandomBand& random, const BandProblem& problem) {
  const Band& band = random.band;
  Eigen::MatrixXd H =
      Eigen::MatrixXd::Zero(4 * static_cast<Index>(band.size() + 1), 4 * static_cast<Index>(band.size() + 1));
  std::vector<BandPose> poses = band.poses;
  poses.push_back({});  // c of the last segment, which it does not read
  for (std::size_t k = 0; k < problem.segments(); ++k) {
    const bool last = k + 1 == problem.segments();
    const SegmentEnd end = !last                        ? SegmentEnd::next_segment
                           : problem.scene.goal_at_rest ? SegmentEnd::rest
                                                        : SegmentEnd::free;
    const auto segment =
        dense_segment(problem.segment_model, &poses[k].x, end, k == 0 ? &problem.scene.start_twist : nullptr);
    for (std::size_t r = 0; segment && r < kSegmentResiduals; ++r) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(H.cols());
      row.segment(4 * static_cast<Index>(k), 12) =
          Eigen::Map<const Eigen::Matrix<double, 12, 1>>(&segment->jacobian[r * kSegmentColumns]);
      H += row * row.transpose();
    }
    for (const auto* list : {&problem.terms[k].at_pose, &problem.terms[k].along_segment}) {
      for (const ClearanceTerm& term : *list) {
        Eigen::Vector3d gradient;
        evaluate_clearance(problem.clearance_model, term,
                           between(&poses[k].x, &poses[k + 1].x, term.fraction), &gradient);
        Eigen::VectorXd row = Eigen::VectorXd::Zero(H.cols());
        row.segment(4 * static_cast<Index>(k), 3) = (1.0 - term.fraction) * gradient;
        row.segment(4 * static_cast<Index>(k) + 4, 3) = term.fraction * gradient;
        H += row * row.transpose();
      }
    }
  }
  return H.block(3, 3, free_count(band), free_count(band));
}

TEST(NormalEquations, AreTheSumOfTheirTerms) {
  Random random(kSeed);
  for (int i = 0; i < 100; ++i) {
    RandomBand scene(random, i, i % 2 == 0 ? kRectangle : Footprint{0.2, {}});
    const BandProblem problem(scene.band, scene.scene, scene.options, 2.0);
    BandEvaluation evaluation(problem);
    ASSERT_TRUE(evaluation.evaluate(scene.band.poses.data()));
    NormalEquations equations;
    evaluation.linearise(equations);
    const Eigen::MatrixXd expected = term_by_term(scene, problem);
    const Eigen::MatrixXd H = dense(equations, free_count(scene.band));
    EXPECT_LT((H - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff())
        << "seed " << kSeed << " case " << i;
  }
}

TEST(NormalEquations, FactorSolvesThem) {
  Random random(kSeed);
  for (int i = 0; i < 100; ++i) {
    RandomBand scene(random, i, kRectangle);
    const BandProblem problem(scene.band, scene.scene, scene.options, 2.0);
    BandEvaluation evaluation(problem);
    ASSERT_TRUE(evaluation.evaluate(scene.band.poses.data()));
    NormalEquations equations;
    const double damping = 1e-4 * evaluation.linearise(equations);
    BandFactor factor;
    ASSERT_TRUE(factor.factorise(equations, damping));
    BandVector x = equations.gradient;
    factor.solve_transposed(x);
    factor.solve(x);
    const Index count = free_count(scene.band);
    const Eigen::MatrixXd A = dense(equations, count) + damping * Eigen::MatrixXd::Identity(count, count);
    const Eigen::VectorXd expected = A.llt().solve(free_part(equations.gradient, count));
    EXPECT_LT((free_part(x, count) - expected).norm(), 1e-9 * expected.norm())
        << "seed " << kSeed << " case " << i;
    for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(x[0][v], 0.0) << "the start moved";
    for (const double value : x[scene.band.size() - 1]) EXPECT_EQ(value, 0.0) << "the goal moved";
  }
}

TEST(NormalEquations, WhatIsNotPositiveDefiniteIsRefused) {
  NormalEquations equations;
  equations.reset(4);
  BandFactor factor;
  EXPECT_FALSE(factor.factorise(equations, 0.0));
  EXPECT_TRUE(factor.factorise(equations, 1.0));
}

}  // namespace
}  // namespace bw::teb
