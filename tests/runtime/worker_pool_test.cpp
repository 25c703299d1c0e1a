#include "runtime/worker_pool.hpp"

#include <algorithm>
#include <latch>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

namespace bw {
namespace {

TEST(WorkerPool, RunsEveryBodyOnce) {
  for (std::size_t threads = 0; threads <= 4; ++threads) {
    WorkerPool pool(threads);
    for (const std::size_t count : {0, 1, 2, 3, 7, 1000}) {
      std::vector<std::atomic<int>> runs(count);
      pool.run(count, [&](std::size_t i) { ++runs[i]; });
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(runs[i], 1) << threads << " " << count << " " << i;
    }
  }
}

// Each body waits for the other: serially this would not end.
TEST(WorkerPool, WorksAtTheSameTime) {
  WorkerPool pool(2);
  std::latch both(2);
  pool.run(2, [&](std::size_t) { both.arrive_and_wait(); });
  EXPECT_TRUE(both.try_wait());
}

// Results that each body writes to a place of its own do not depend on who runs what: sum of i^2, 0 to 63, is
// 63 * 64 * 127 / 6 = 85344 in every call.
TEST(WorkerPool, ManyShortCallsGiveTheSameResult) {
  WorkerPool pool(4);
  for (int call = 0; call < 5000; ++call) {
    std::vector<std::size_t> squares(64);
    pool.run(squares.size(), [&](std::size_t i) { squares[i] = i * i; });
    ASSERT_EQ(std::accumulate(squares.begin(), squares.end(), std::size_t{0}), 85344U) << call;
  }
}

TEST(WorkerPool, HandsOnTheExceptionOfABodyAndGoesOn) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    WorkerPool pool(threads);
    for (int call = 0; call < 200; ++call) {
      std::atomic<int> begun = 0;
      const auto third_fails = [&](std::size_t i) {
        ++begun;
        if (i == 3) throw std::runtime_error("third");
      };
      EXPECT_THROW(pool.run(100, third_fails), std::runtime_error);
      EXPECT_GE(begun, 4);
      if (threads == 1) {
        EXPECT_EQ(begun, 4);  // those after it are left out
      }
      std::atomic<int> after = 0;
      pool.run(8, [&](std::size_t) { ++after; });
      EXPECT_EQ(after, 8);
    }
  }
}

TEST(WorkerPool, OneExceptionOfManyIsThrown) {
  WorkerPool pool(4);
  for (int call = 0; call < 200; ++call) {
    EXPECT_THROW(pool.run(50, [](std::size_t) { throw std::logic_error("each"); }), std::logic_error);
  }
}

TEST(WorkerPool, ACallFromInsideABodyRunsSerially) {
  WorkerPool pool(3);
  std::vector<int> sums(10);
  pool.run(sums.size(), [&](std::size_t i) { pool.run(10, [&](std::size_t) { ++sums[i]; }); });
  EXPECT_EQ(sums, std::vector<int>(10, 10));
}

TEST(WorkerPool, EndsAtOnceWhenItNeverWorked) {
  for (int i = 0; i < 100; ++i) WorkerPool pool(4);
}

}  // namespace
}  // namespace bw
