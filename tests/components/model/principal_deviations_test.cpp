#include "components/model/principal_deviations.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

// Eigenvalues by hand: of diag(1, 4) 4 and 1; of a on the diagonal and c beside it a + c and a - c.
TEST(PrincipalDeviations, AreTheRootsOfTheEigenvalues) {
  const Vector2 apart = principal_deviations(Eigen::Vector2d(1.0, 4.0).asDiagonal());
  EXPECT_NEAR((apart - Vector2(2.0, 1.0)).norm(), 0.0, 1e-12);
  Eigen::Matrix2d together;
  together << 0.05, -0.04, -0.04, 0.05;
  EXPECT_NEAR((principal_deviations(together) - Vector2(0.3, 0.1)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace bw
