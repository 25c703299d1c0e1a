// The whole component, carried away in an office that it has driven through for two minutes.
#include <gtest/gtest.h>

#include "components/lab/bench/slam/bench_kidnaps.hpp"

namespace bw {
namespace {

// An office tells where one is (99 of 100 by one scan, components/slam/README.md): LOST within half a second, and its
// place again within 10 s and 5 m.
TEST(Kidnaps, SlamFindsItsPlaceAndNeverSaysOkMeanwhile) {
  const RecordedDrive drive =
      buildings::drive_through(buildings::make_building(buildings::BuildingKind::office, 5),
                               {.seed = 5, .longest = Duration::seconds(120.0)});
  const std::vector<Kidnap> kidnaps = drive_kidnapped(drive, {.times = 4, .stay = 12.0, .seed = 5});
  ASSERT_EQ(kidnaps.size(), 4U);
  for (const Kidnap& kidnap : kidnaps) {
    ASSERT_TRUE(kidnap.found_after);
    EXPECT_LT(*kidnap.found_after, 10.0);
    EXPECT_LT(kidnap.way, 5.0);
    EXPECT_LT(kidnap.wrong_while_ok, 1.5) << "the state is told once a second";
  }
}

}  // namespace
}  // namespace bw
