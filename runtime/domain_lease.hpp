// A DDS domain for some processes that share it with nobody: a planner process and who asks it, a test and what it starts.
#pragma once

#include <set>
#include <string>

namespace bw {

/// Domains that may be leased, the highest first. Domain 0 is everybody's; the ports of domain 101 and above
/// reach into those that Linux gives to outgoing sockets (32768 and above).
constexpr int kFirstDomain = 100;
constexpr int kLastDomain = 1;

/// Domains of which any UDP port of this machine is open, by RTPS's rule 7400 + 250 domain. Throws
/// std::runtime_error.
std::set<int> domains_in_use();

/// A name in the kernel's abstract socket namespace, which exists as long as somebody has it open: no file is
/// left behind, and it is as wide as the ports are (a network namespace). Processes that are started inherit
/// it, so that what outlives its owner keeps its domain.
class DomainLease {
 public:
  /// The first domain that is free. Throws std::runtime_error when none is. `name` is for tests of the lease
  /// itself.
  explicit DomainLease(const std::string& name = "bandwagon_domain_");
  ~DomainLease();
  DomainLease(const DomainLease&) = delete;
  DomainLease& operator=(const DomainLease&) = delete;

  [[nodiscard]] int domain() const { return domain_; }

 private:
  int domain_ = kFirstDomain;
  int socket_ = -1;
};

}  // namespace bw
