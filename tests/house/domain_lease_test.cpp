// Tests that run at once share no DDS domain, with each other or with who else is on this machine.
#include "runtime/domain_lease.hpp"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bw::test {
namespace {

/// Leases that no other test sees.
std::string name_of_this_test() {
  return "bandwagon_lease_test_" + std::to_string(getpid()) + "_" +
         testing::UnitTest::GetInstance()->current_test_info()->name() + "_";
}

/// By the kernel's own list of names, where an abstract one begins with @.
bool is_leased(const std::string& name, int domain) {
  std::ifstream names("/proc/net/unix");
  const std::string wanted = " @" + name + std::to_string(domain);
  for (std::string line; std::getline(names, line);) {
    if (line.ends_with(wanted)) return true;
  }
  return false;
}

class OpenPort {
 public:
  explicit OpenPort(int port) : socket_(socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    is_open_ = bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  }
  ~OpenPort() { close(socket_); }
  OpenPort(const OpenPort&) = delete;
  OpenPort& operator=(const OpenPort&) = delete;
  [[nodiscard]] bool is_open() const { return is_open_; }

 private:
  int socket_;
  bool is_open_ = false;
};

TEST(DomainLease, ThisProgramHasOneAndSaysWhich) {
  const char* text = std::getenv("ROS_DOMAIN_ID");
  ASSERT_NE(text, nullptr);
  EXPECT_GE(std::atoi(text), 1);  // 0 is everybody's
  EXPECT_LE(std::atoi(text),
            100);  // 7400 + 250 * 100 + 249 = 32649, below 32768 where outgoing sockets begin
}

TEST(DomainLease, TwoAtOnceDiffer) {
  const std::string name = name_of_this_test();
  const DomainLease one(name), two(name);
  EXPECT_NE(one.domain(), two.domain());
}

TEST(DomainLease, EndsWithItsProcessHoweverThatEnds) {
  const std::string name = name_of_this_test();
  int ready[2] = {};
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const DomainLease lease(name);
    const int domain = lease.domain();
    if (write(ready[1], &domain, sizeof(domain)) < 0) _exit(1);
    for (;;) pause();
  }
  int domain = 0;
  ASSERT_EQ(read(ready[0], &domain, sizeof(domain)), static_cast<ssize_t>(sizeof(domain)));
  EXPECT_TRUE(is_leased(name, domain));
  EXPECT_NE(DomainLease(name).domain(), domain) << "its domain is passed over";
  kill(child, SIGKILL);
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  close(ready[0]);
  close(ready[1]);
  EXPECT_FALSE(is_leased(name, domain)) << "nothing is left to clean up";
}

TEST(DomainLease, ADomainWithAnOpenPortIsNotTaken) {
  // On a domain that is leased to this program, so that no other test is disturbed.
  const int domain = std::atoi(std::getenv("ROS_DOMAIN_ID"));
  EXPECT_FALSE(domains_in_use().contains(domain));
  // By the RTPS specification (9.6.1.1): 7400 + 250 domain for discovery by multicast, + 10 and + 11 for the
  // first participant, and 249 is the last port before the next domain's.
  for (const int offset : {0, 1, 10, 11, 249}) {
    const OpenPort somebody(7400 + 250 * domain + offset);
    ASSERT_TRUE(somebody.is_open()) << offset;
    EXPECT_TRUE(domains_in_use().contains(domain)) << offset;
    EXPECT_NE(DomainLease(name_of_this_test()).domain(), domain) << offset;
  }
  EXPECT_FALSE(domains_in_use().contains(domain));
}

TEST(DomainLease, WhatAProgramStartsKeepsItsDomain) {
  const std::string name = name_of_this_test();
  std::optional<DomainLease> lease(name);
  const int domain = lease->domain();
  int ends[2] = {};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    // Another program, which answers what it is told until this one closes its end.
    dup2(ends[1], STDIN_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    execlp("cat", "cat", nullptr);
    _exit(127);
  }
  close(ends[1]);
  lease.reset();
  char answer = 'x';
  ASSERT_EQ(write(ends[0], &answer, 1), 1);
  ASSERT_EQ(read(ends[0], &answer, 1), 1) << "it runs";
  EXPECT_TRUE(is_leased(name, domain)) << "it may be on the domain still";
  close(ends[0]);
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  EXPECT_FALSE(is_leased(name, domain));
}

TEST(DomainLease, WhenAllAreTakenItSaysSo) {
  const std::string name = name_of_this_test();
  std::vector<std::unique_ptr<DomainLease>> all;
  try {
    for (;;) all.push_back(std::make_unique<DomainLease>(name));
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "no DDS domain is free: each from 1 to 100 is leased or has open ports");
  }
  EXPECT_LE(all.size(), 100U);
  EXPECT_GE(all.size(), 10U);  // that so many tests may run at once beside whoever else is here
}

}  // namespace
}  // namespace bw::test
