#include "components/lab/shards/domain_lease.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace bw {
namespace {

class DomainLeases : public testing::Test {
 protected:
  DomainLeases() {
    std::filesystem::create_directories(folder);
    setenv("XDG_RUNTIME_DIR", folder.c_str(), 1);
    unsetenv("ROS_DOMAIN_ID");
  }
  ~DomainLeases() override {
    unsetenv("ROS_DOMAIN_ID");
    std::filesystem::remove_all(folder);
  }
  static std::string leased() {
    const char* domain = std::getenv("ROS_DOMAIN_ID");
    return domain == nullptr ? "" : domain;
  }
  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "bandwagon_leases";
};

// Locks of one process on files that it opened twice are two.
TEST_F(DomainLeases, AreOneForEachAndGivenBack) {
  {
    const DomainLease first;
    EXPECT_EQ(leased(), "1");
    unsetenv("ROS_DOMAIN_ID");
    const DomainLease second;
    EXPECT_EQ(leased(), "2");
    unsetenv("ROS_DOMAIN_ID");
  }
  const DomainLease again;
  EXPECT_EQ(leased(), "1");
}

TEST_F(DomainLeases, LeaveADomainThatIsGiven) {
  setenv("ROS_DOMAIN_ID", "42", 1);
  const DomainLease lease;
  EXPECT_EQ(leased(), "42");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace bw
