#include "runtime/host/real_time.hpp"

#include <cerrno>
#include <cstring>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

namespace bw {
namespace {

constexpr int kPriority = 20;  // above what has none, below what a kernel's own interrupt threads have
constexpr const char* kAdvice =
    "; allow it by the lines \"USER - rtprio 20\" and \"USER - memlock unlimited\" in /etc/security/limits.d/bandwagon.conf "
    "and a new login";

/// A part of the memory cannot be locked: with a limit, what is allocated later would fail instead.
bool may_lock_all() {
  rlimit limit{};
  return getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
}

int set_priority(int policy, int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), policy, &parameters);
}

}  // namespace

std::string take_real_time_priority() {
  const int error = set_priority(SCHED_FIFO, kPriority);
  if (error == 0) return {};
  return std::string("no real-time priority: ") + std::strerror(error) + kAdvice;
}

std::string lock_memory() {
  if (!may_lock_all()) return std::string("memory is not locked: its limit is not unlimited") + kAdvice;
  if (mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0) return {};
  return std::string("memory is not locked: ") + std::strerror(errno) + kAdvice;
}

std::string missing_real_time_rights() {
  int policy = SCHED_OTHER;
  sched_param before{};
  pthread_getschedparam(pthread_self(), &policy, &before);
  const std::string missing = take_real_time_priority();
  pthread_setschedparam(pthread_self(), policy, &before);
  if (!missing.empty()) return missing;
  return may_lock_all() ? "" : std::string("memory cannot be locked") + kAdvice;
}

}  // namespace bw
