// What a test has to itself on this machine: a DDS domain, and a folder for temporary files, state and links
// to devices. The process and those it starts find both by the usual environment variables; the folder goes
// when this ends.
#pragma once

#include "runtime/domain_lease.hpp"
#include "runtime/temporary_folder.hpp"

namespace bw::test {

class TestEnvironment {
 public:
  /// Sets ROS_DOMAIN_ID, TMPDIR, TEST_TMPDIR, XDG_CONFIG_HOME, XDG_STATE_HOME and XDG_RUNTIME_DIR, whatever
  /// they were: a domain that a user has chosen has the user's robot on it. Before any thread is started.
  /// Throws std::runtime_error.
  TestEnvironment();

 private:
  TemporaryFolder folder_;
  DomainLease lease_;
};

}  // namespace bw::test
