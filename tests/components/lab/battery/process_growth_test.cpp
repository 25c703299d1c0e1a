#include "components/lab/battery/process_growth.hpp"

#include <algorithm>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace bw {
namespace {

/// An hour, a look a minute: 2 MB an hour on top of what fills in the first ten minutes.
std::vector<ProcessSample> an_hour() {
  std::vector<ProcessSample> samples;
  for (double t = 0.0; t <= 3600.0; t += 60.0)
    samples.push_back({.t = t,
                       .rss = 80.0 + 8.0 * std::min(1.0, t / 600.0) + 2.0 * t / 3600.0,
                       .descriptors = t < 600.0 ? 20 : 30,
                       .threads = t == 1800.0 ? 8 : 7});
  return samples;
}

TEST(ProcessGrowth, IsTheSlopeOnceItIsWarm) {
  EXPECT_NEAR(growth(an_hour(), 600.0), 2.0, 1e-9);
  EXPECT_GT(growth(an_hour(), 0.0), 4.0);     // what fills at first is no growth
  EXPECT_EQ(growth(an_hour(), 3600.0), 0.0);  // one look tells none
}

TEST(ProcessGrowth, SpreadIsTheMostLessTheLeast) {
  EXPECT_EQ(spread(an_hour(), 600.0).descriptors, 0);
  EXPECT_EQ(spread(an_hour(), 0.0).descriptors, 10);
  EXPECT_EQ(spread(an_hour(), 600.0).threads, 1);
  EXPECT_EQ(spread({}, 0.0).threads, 0);
}

TEST(ProcessGrowth, AnOpenFileIsADescriptorAndAStrangerIsNobody) {
  const auto before = sample_process(getpid(), 0.0);
  const int file = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const auto after = sample_process(getpid(), 1.0);
  close(file);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->descriptors, before->descriptors + 1);
  EXPECT_EQ(after->threads, 1);
  EXPECT_GT(after->rss, 1.0);
  EXPECT_FALSE(sample_process(1 << 30, 0.0));  // beyond the highest id that Linux gives
}

}  // namespace
}  // namespace bw
