#include "tests/test_environment.hpp"

#include <cstdlib>
#include <string>

namespace bw::test {

TestEnvironment::TestEnvironment() {
  for (const char* name : {"TMPDIR", "TEST_TMPDIR", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"})
    setenv(name, folder_.path().c_str(), 1);
  setenv("ROS_DOMAIN_ID", std::to_string(lease_.domain()).c_str(), 1);
}

}  // namespace bw::test
