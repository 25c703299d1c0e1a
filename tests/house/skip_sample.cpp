// Not a test of its own: what check_skips_test.sh runs, to see how programs end in which tests pass, skip and
// fail.
#include <gtest/gtest.h>

TEST(Sample, Passes) {}
TEST(Sample, Skips) { GTEST_SKIP() << "as if recorded data were not at hand"; }
TEST(Sample, Fails) { FAIL() << "as it must"; }
