#include "runtime/cli/doctor_rights.hpp"

#include <cstdint>
#include <thread>

#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

namespace bw::cli {
namespace {

constexpr const char* kHow =
    "; allow it: put the lines `@dialout - rtprio 50` and `@dialout - memlock unlimited` into "
    "/etc/security/limits.d/bandwagon.conf, and log out and in again";

bool may_be_realtime() {
  bool may = false;
  // On a thread that ends: this one stays as it is.
  std::jthread([&may] {
    const sched_param lowest{.sched_priority = sched_get_priority_min(SCHED_FIFO)};
    may = pthread_setschedparam(pthread_self(), SCHED_FIFO, &lowest) == 0;
  }).join();
  return may;
}

}  // namespace

void check_realtime_rights(DoctorReport& report) {
  if (may_be_realtime()) {
    report.ok("real-time priority is allowed");
  } else {
    report.warn(std::string("no real-time priority: on a busy machine the base is commanded late") + kHow);
  }
  rlimit locked{};
  getrlimit(RLIMIT_MEMLOCK, &locked);
  constexpr rlim_t kEnough = 512U << 20U;  // a process with the base, and much to spare
  if (geteuid() == 0 || locked.rlim_cur == RLIM_INFINITY || locked.rlim_cur >= kEnough) {
    report.ok("memory may be locked");
  } else {
    report.warn(
        fmt::format("only {} kB of memory may be locked: a page that was swapped out delays the base{}",
                    locked.rlim_cur / 1024, kHow));
  }
}

}  // namespace bw::cli
