// Tests beside somebody else's ROS 2 on ten domains, and beside themselves: a selection of programs that
// other tests are, which come into their domains (test_environment.hpp) and look at what is theirs. The whole
// suite beside unrelated_processes, by hand:
//   build/release/bin/unrelated_processes & ctest --test-dir build/release; kill -INT $!
#include <csignal>
#include <list>
#include <sstream>

#include <gtest/gtest.h>

#include "runtime/domain_lease.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"
#include "tests/shared_memory.hpp"

namespace bw::test {
namespace {

class UnrelatedProcesses : public testing::Test {
 protected:
  void SetUp() override {
    eventually([this] {
      return !unrelated_processes_.running() || unrelated_processes_.out().find('\n') != std::string::npos;
    });
    std::istringstream line(unrelated_processes_.out());
    for (int domain = 0; line >> domain;) domains_.push_back(domain);
    ASSERT_EQ(domains_.size(), 10U) << unrelated_processes_.err();
  }

  /// Not by a kill, which would leave their shared memory behind.
  void TearDown() override {
    unrelated_processes_.signal(SIGINT);
    EXPECT_EQ(unrelated_processes_.wait(std::chrono::seconds(60)), 0) << unrelated_processes_.err();
    for (const int domain : domains_) EXPECT_EQ(shared_ports_of(domain), "");
  }

  Process unrelated_processes_{{UNRELATED_PROCESSES}};
  std::vector<int> domains_;
};

TEST_F(UnrelatedProcesses, AreAllThatATestMustNotTakeForItsOwn) {
  for (const int domain : domains_) {
    EXPECT_TRUE(domains_in_use().contains(domain));
    EXPECT_NE(shared_ports_of(domain), "");
  }
  EXPECT_NE(in_shared_memory(unrelated_processes_.id()), "");
}

TEST_F(UnrelatedProcesses, DisturbNoTestAndTwoOfATestDoNotDisturbEachOther) {
  // As from the shell of a user whose robot is on such a domain.
  const std::map<std::string, std::string> environment = {
      {"ROS_DOMAIN_ID", std::to_string(domains_.front())}};
  std::list<Process> tests;
  for (const char* program : {TEST_DDS, TEST_SHARED_MEMORY, TEST_SERVICE_WIRE}) {
    for (int twin = 0; twin < 2; ++twin)
      tests.emplace_back(std::vector<std::string>{program, "--gtest_brief=1"}, environment);
  }
  for (Process& test : tests) EXPECT_EQ(test.wait(std::chrono::seconds(240)), 0) << test.out() << test.err();
  EXPECT_TRUE(unrelated_processes_.running()) << unrelated_processes_.err();
}

}  // namespace
}  // namespace bw::test
