// A figure that was asked for and is not reached. The test says both, and holds what is reached, so that a loss shows.
// Tests with such figures are CTest entries of the label `shortfall` (SHORTFALL of bw_test): ctest -L shortfall -V.
#pragma once

#include <cstdio>

#include <gtest/gtest.h>

namespace bw::test {

/// `reached` should be at least `asked`; it must be at least `kept`.
inline void expect_at_least(const char* what, double asked, double kept, double reached) {
  std::printf("%s: asked >= %g, reached %.4g%s, kept at %g\n", what, asked, reached,
              reached >= asked ? "" : " (falls short)", kept);
  EXPECT_GE(reached, kept) << what;
}

/// `reached` should be at most `asked`; it must be at most `kept`.
inline void expect_at_most(const char* what, double asked, double kept, double reached) {
  std::printf("%s: asked <= %g, reached %.4g%s, kept at %g\n", what, asked, reached,
              reached <= asked ? "" : " (falls short)", kept);
  EXPECT_LE(reached, kept) << what;
}

}  // namespace bw::test
