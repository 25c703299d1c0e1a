// A DDS domain that no other process of this user holds: drives that run beside each other each have sockets of their own.
#pragma once

namespace bw {

/// Taken by a lock on a file, which the system gives back however the process ends.
class DomainLease {
 public:
  /// Sets ROS_DOMAIN_ID, where it is not set, to the first of 1 to 101 that is free. Throws std::runtime_error where none
  /// is.
  DomainLease();
  ~DomainLease();
  DomainLease(const DomainLease&) = delete;
  DomainLease& operator=(const DomainLease&) = delete;

 private:
  int lock_ = -1;
};

}  // namespace bw
