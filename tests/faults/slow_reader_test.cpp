// A reader that stands still (SIGSTOP): who writes goes on, who else reads loses nothing, and nothing piles up (row 25). By counts: how
// long a write takes is for a quiet machine, and printed.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>
#include <std_msgs/msg/string.hpp>

#include "runtime/process_memory.hpp"
#include "tests/faults/outside_driver.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using String = std_msgs::msg::String;
using Clock = std::chrono::steady_clock;

/// Of 1 kB each, at 1 kHz at most: three seconds, less than the frozen one counts as there; BANDWAGON_SLOW_READER_MESSAGES asks for more.
int messages() {
  const char* text = std::getenv("BANDWAGON_SLOW_READER_MESSAGES");
  return text != nullptr ? std::max(1, std::atoi(text)) : 3000;
}

TEST(SlowReader, StandsStillAndNobodyElseLosesAnything) {
  dds::Participant writing({.network = dds::Network::from_environment({})});
  dds::Participant reading({.network = dds::Network::from_environment({})});
  const auto writer = writing.create_writer(ros_end<String>("slow"));
  const auto healthy = reading.create_reader(ros_end<String>("slow"), [] {});
  Process frozen({FROZEN_READER, "slow"});
  ASSERT_TRUE(eventually([&] { return frozen.out() == "ready\n" && writer->matched_readers() == 2; }))
      << frozen.err();
  frozen.signal(SIGSTOP);

  String message;
  message.data(std::string(1000, 'x'));
  std::vector<std::uint8_t> cdr;
  serialize(message, cdr);
  int refused = 0, lost = 0;
  double before = 0.0;
  std::vector<double> spent;
  dds::Sample sample;
  std::uint64_t last = 0;
  for (int i = 0; i < messages(); ++i) {
    if (i == 100) before = peak_memory_mb();  // what the first ones take is taken
    const auto begin = Clock::now();
    refused += writer->write(cdr) ? 0 : 1;
    spent.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    ASSERT_TRUE(poll_until(Clock::now() + std::chrono::seconds(30), std::chrono::microseconds(100),
                           [&] { return healthy->take(sample); }))
        << "message " << i;
    lost += last != 0 && sample.sequence != last + 1 ? 1 : 0;
    last = sample.sequence;
    std::this_thread::sleep_until(begin + std::chrono::milliseconds(1));
  }
  const double grown = peak_memory_mb() - before;
  std::ranges::sort(spent);
  std::printf(
      "a reader stands still, %d messages: writes p99 %.2f ms, worst %.2f ms; memory grew by %.1f MB\n",
      messages(), spent[spent.size() * 99 / 100], spent.back(), grown);
  EXPECT_EQ(refused, 0);
  EXPECT_EQ(lost, 0);
  EXPECT_LE(grown, 10.0);
  frozen.signal(SIGKILL);
}

}  // namespace
}  // namespace bw::test
