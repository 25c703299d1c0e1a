#include "runtime/serial/background_jobs.hpp"

#include <future>
#include <stdexcept>

#include <gtest/gtest.h>

namespace bw::test {
namespace {

/// Until the jobs before this are done: they go in their order.
void wait_for(BackgroundJobs& jobs) {
  std::promise<void> done;
  jobs.add([&done] { done.set_value(); });
  done.get_future().wait();
}

// The thread is no lane: what left it would end the process, and whoever asked for the job would not know
// why.
TEST(BackgroundJobs, WhatAJobThrowsIsThrownToWhoAsksAndTheNextIsDone) {
  BackgroundJobs jobs;
  EXPECT_NO_THROW(jobs.rethrow());
  jobs.add([] { throw std::runtime_error("no such device"); });
  jobs.add([] { throw 7; });
  wait_for(jobs);
  try {
    jobs.rethrow();
    FAIL() << "nothing is thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no such device");  // the first that failed
  }
  EXPECT_NO_THROW(jobs.rethrow());  // once
}

}  // namespace
}  // namespace bw::test
