// The main() of every test program. Tests that need recorded data skip themselves without it; a program in
// which one did ends with 77, which CTest shows as skipped where the entry says so (RECORDED of bw_test) and
// as failed where it does not. A program in which anything fails, or that runs nothing, fails. Its DDS domain
// and its folder for temporary files are its own, and go when it ends.
#include <cstdio>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/test_environment.hpp"

int main(int argc, char** argv) {
  constexpr int kSkipped = 77;
  testing::InitGoogleMock(&argc, argv);
  const bw::test::TestEnvironment environment;
  const int status = RUN_ALL_TESTS();
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  if (status != 0 || testing::GTEST_FLAG(list_tests)) return status;
  if (tests.test_to_run_count() == 0) {
    std::fprintf(stderr, "no test has such a name: %s\n", testing::GTEST_FLAG(filter).c_str());
    return 1;
  }
  if (tests.skipped_test_count() == 0) return 0;
  if (std::getenv("BANDWAGON_SHARED") != nullptr) {
    std::fprintf(stderr, "%d tests were skipped although BANDWAGON_SHARED is set\n",
                 tests.skipped_test_count());
    return 1;
  }
  return kSkipped;
}
