#include "components/lab/shards/domain_lease.hpp"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace bw {
namespace {

constexpr int kLast = 101;  // ports of higher ones are those that the system gives to clients

std::filesystem::path folder() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  const std::filesystem::path base = runtime != nullptr && *runtime != '\0'
                                         ? std::filesystem::path(runtime)
                                         : std::filesystem::temp_directory_path();
  return base / ("bandwagon-domains-" + std::to_string(getuid()));
}

}  // namespace

DomainLease::DomainLease() {
  const char* given = std::getenv("ROS_DOMAIN_ID");
  if (given != nullptr && *given != '\0') return;
  const std::filesystem::path locks = folder();
  std::filesystem::create_directories(locks);
  for (int domain = 1; domain <= kLast; ++domain) {
    const int lock = open((locks / std::to_string(domain)).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    if (lock < 0) throw std::runtime_error(locks.string() + ": cannot be written");
    if (flock(lock, LOCK_EX | LOCK_NB) == 0) {
      lock_ = lock;
      setenv("ROS_DOMAIN_ID", std::to_string(domain).c_str(), 1);
      return;
    }
    close(lock);
  }
  throw std::runtime_error(locks.string() + ": all domains from 1 to 101 are held by other processes");
}

DomainLease::~DomainLease() {
  if (lock_ >= 0) close(lock_);
}

}  // namespace bw
