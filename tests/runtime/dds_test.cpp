// The border to DDS: what reaches whom, and that nothing but the loopback device carries it.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "runtime/dds/loopback_sockets.hpp"
#include "runtime/dds/participant.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/shared_memory.hpp"

namespace bw::dds {
namespace {

ParticipantOptions local() { return {.network = Network::from_environment(Transport::localhost)}; }

std::string device_of(int descriptor) {
  char device[16] = {};
  socklen_t length = sizeof(device);
  EXPECT_EQ(getsockopt(descriptor, SOL_SOCKET, SO_BINDTODEVICE, static_cast<char*>(device), &length), 0);
  return static_cast<const char*>(device);
}

TEST(LoopbackSockets, EverySocketOfAParticipantIsBoundToLo) {
  const std::set<int> before = open_datagram_sockets();
  const Participant participant(local());
  int checked = 0;
  for (const int descriptor : open_datagram_sockets()) {
    if (before.contains(descriptor)) continue;
    EXPECT_EQ(device_of(descriptor), "lo");
    ++checked;
  }
  EXPECT_GE(checked, 2);  // metatraffic and user data at least
}

// Fast DDS has threads that open and close sockets while a participant is created.
TEST(LoopbackSockets, OneThatHasBeenClosedMeanwhileIsNoFailure) {
  const int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
  ASSERT_GE(descriptor, 0);
  close(descriptor);
  EXPECT_NO_THROW(bind_to_loopback({descriptor}));
}

TEST(LoopbackSockets, HasNothingInSharedMemory) {
  const Participant participant(local());
  EXPECT_EQ(test::in_shared_memory(getpid()), "");
  EXPECT_EQ(test::shared_ports_of(local().network.domain_id), "");
}

TEST(Participant, TwoParticipantsDiscoverEachOtherAndExchangeASample) {
  Participant one(local());
  Participant two(local());
  const EndpointOptions options{.topic = "rt/chatter",
                                .type = "std_msgs::msg::dds_::String_",
                                .qos = Qos::latched(),
                                .user_data = "typehash=x;"};
  std::mutex mutex;
  std::condition_variable wake;
  bool arrived = false;
  const auto reader = two.create_reader(options, [&] {
    const std::lock_guard lock(mutex);
    arrived = true;
    wake.notify_one();
  });
  const auto writer = one.create_writer(options);
  const std::vector<std::uint8_t> cdr = {0, 1, 0, 0, 3, 0, 0, 0, 'h', 'i', 0};
  ASSERT_TRUE(writer->write(cdr));
  std::unique_lock lock(mutex);
  ASSERT_TRUE(wake.wait_for(lock, std::chrono::seconds(20), [&] { return arrived; }));
  lock.unlock();
  Sample sample;
  ASSERT_TRUE(reader->take(sample));
  sample.cdr.resize(cdr.size());  // RTPS pads to four bytes
  EXPECT_EQ(sample.cdr, cdr);
  EXPECT_EQ(sample.writer, writer->guid());
  bool seen = false;
  for (const Endpoint& endpoint : two.endpoints()) {
    if (!endpoint.is_writer || endpoint.is_local) continue;
    seen = true;
    EXPECT_EQ(endpoint.topic, "rt/chatter");
    EXPECT_EQ(endpoint.type, "std_msgs::msg::dds_::String_");
    EXPECT_EQ(endpoint.user_data, "typehash=x;");
    EXPECT_EQ(endpoint.qos.durability, Durability::transient_local);
  }
  EXPECT_TRUE(seen);
}

/// The port on which discovery by unicast seeks the participant of this index (RTPS 9.6.1.1).
class SoughtPort {
 public:
  explicit SoughtPort(int index) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int domain = Network::from_environment(Transport::localhost).domain_id;
    address.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * domain + 10 + 2 * index));
    const int on = 1;
    setsockopt(socket_, SOL_SOCKET, SO_TIMESTAMP, &on, sizeof(on));
    const timeval limit{.tv_sec = 20, .tv_usec = 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof(limit));
    is_bound_ = bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0;
  }
  ~SoughtPort() { close(socket_); }
  SoughtPort(const SoughtPort&) = delete;
  SoughtPort& operator=(const SoughtPort&) = delete;

  bool is_bound() const { return is_bound_; }
  /// When the kernel got the next datagram [s]; -1: none came.
  double next_arrival() const {
    char datagram[2048];
    char control[256];
    iovec data{.iov_base = datagram, .iov_len = sizeof(datagram)};
    msghdr message{};
    message.msg_iov = &data;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof(control);
    if (recvmsg(socket_, &message, 0) < 0) return -1.0;
    const cmsghdr* stamp = CMSG_FIRSTHDR(&message);
    if (stamp == nullptr || stamp->cmsg_type != SCM_TIMESTAMP) return -1.0;
    timeval time{};
    std::memcpy(&time, CMSG_DATA(stamp), sizeof(time));
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }

 private:
  int socket_ = socket(AF_INET, SOCK_DGRAM, 0);
  bool is_bound_ = false;
};

// Who comes may miss the answer to its first announcement, as rmw_fastrtps does in half of all starts: Fast
// DDS sends that before it hears. ROS 2's tools look around for half a second (--spin-time), and discovery of
// the ends takes 0.1 s of it. The first five announcements are 0.1 s apart by themselves; of the gaps behind
// them the median, which a machine that is busy elsewhere does not move.
TEST(Participant, IsAnnouncedAgainWithinTheTimeThatToolsLookAround) {
  const SoughtPort port(31);
  ASSERT_TRUE(port.is_bound());
  const Participant participant(local());
  constexpr int kFirst = 6, kGaps = 7;
  for (int i = 0; i < kFirst; ++i) ASSERT_GT(port.next_arrival(), 0.0);
  std::vector<double> gaps;
  double before = port.next_arrival();
  while (gaps.size() < kGaps) {
    const double now = port.next_arrival();
    ASSERT_GT(now, 0.0);
    gaps.push_back(now - std::exchange(before, now));
  }
  std::ranges::sort(gaps);
  EXPECT_LT(gaps[kGaps / 2], 0.4);
}

ParticipantOptions alone(Transport transport) {
  return {.network = Network::from_environment(transport), .alone = true};
}

class Alone : public testing::TestWithParam<Transport> {};

TEST_P(Alone, OpensNoPortAndItsOwnEndsMeet) {
  const std::set<int> before = open_datagram_sockets();
  Participant participant(alone(GetParam()));
  const EndpointOptions options{.topic = "rt/chatter",
                                .type = "std_msgs::msg::dds_::String_",
                                .qos = Qos::latched(),
                                .user_data = "typehash=x;"};
  const auto writer = participant.create_writer(options);
  const std::vector<std::uint8_t> cdr = {0, 1, 0, 0, 3, 0, 0, 0, 'h', 'i', 0, 0};
  const auto reader = participant.create_reader(options, [] {});
  EXPECT_EQ(writer->matched_readers(), 1);
  EXPECT_EQ(reader->matched_writers(), 1);
  ASSERT_TRUE(writer->write(cdr));
  Sample sample;
  ASSERT_TRUE(reader->take(sample)) << "a synchronous write can be read when it returns";
  EXPECT_EQ(sample.cdr, cdr);
  std::set<int> opened = open_datagram_sockets();
  std::erase_if(opened, [&](int descriptor) { return before.contains(descriptor); });
  EXPECT_TRUE(opened.empty());
}

// KEEP_LAST, and a latched sample for who comes later: as DDS has it.
TEST(Bus, ReadersKeepTheNewestAndLateOnesGetWhatIsLatched) {
  Participant participant(alone(Transport::localhost));
  EndpointOptions options{
      .topic = "rt/a", .type = "std_msgs::msg::dds_::String_", .qos = Qos::standard(2), .user_data = {}};
  int heard = 0;
  const auto reader = participant.create_reader(options, [&] { ++heard; });
  options.qos = Qos::latched();
  const auto writer = participant.create_writer(options);
  for (std::uint8_t i = 1; i <= 3; ++i) ASSERT_TRUE(writer->write(std::vector{i}));
  EXPECT_EQ(heard, 3);
  Sample sample;
  for (std::uint8_t i = 2; i <= 3; ++i) {
    ASSERT_TRUE(reader->take(sample));
    EXPECT_EQ(sample.cdr, std::vector{i});
    EXPECT_EQ(sample.sequence, i);
    EXPECT_EQ(sample.writer, writer->guid());
  }
  EXPECT_FALSE(reader->take(sample));
  const auto late = participant.create_reader(options, [&] { ++heard; });
  EXPECT_EQ(heard, 4);
  ASSERT_TRUE(late->take(sample));
  EXPECT_EQ(sample.cdr, std::vector<std::uint8_t>{3});
  EXPECT_FALSE(late->take(sample));
  options.qos.durability = Durability::volatile_;
  const auto weak = participant.create_writer(options);
  EXPECT_EQ(weak->matched_readers(), 1) << "who asks for latched samples is not matched";
  options.type = "std_msgs::msg::dds_::Bool_";
  EXPECT_THROW(participant.create_writer(options), std::runtime_error);
}

TEST(Bus, RepliesFindTheirRequest) {
  Participant participant(alone(Transport::localhost));
  const EndpointOptions options{
      .topic = "rq/a", .type = "std_msgs::msg::dds_::String_", .qos = {}, .user_data = {}};
  const auto server = participant.create_reader(options, [] {});
  const auto client = participant.create_writer(options);
  ASSERT_TRUE(client->is_matched(server->guid()));
  const SampleIdentity asker{server->guid(), 7};
  const auto identity = client->write_related(std::vector<std::uint8_t>{1}, asker);
  Sample sample;
  ASSERT_TRUE(server->take(sample));
  EXPECT_EQ(sample.related, asker);
  EXPECT_EQ(identity, (SampleIdentity{sample.writer, static_cast<std::int64_t>(sample.sequence)}));
}

TEST_P(Alone, SeesNobodyAndNobodySeesIt) {
  const Participant hidden(alone(GetParam()));
  const Participant hidden_too(alone(GetParam()));
  const Participant one(local()), two(local());
  // By the time these two have met, who could be heard at all would have been.
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while ((one.remote_participants().empty() || two.remote_participants().empty()) &&
         std::chrono::steady_clock::now() < limit)
    std::this_thread::yield();
  EXPECT_EQ(one.remote_participants(), std::vector{two.guid()});
  EXPECT_EQ(two.remote_participants(), std::vector{one.guid()});
  EXPECT_TRUE(hidden.remote_participants().empty());
  EXPECT_TRUE(hidden_too.remote_participants().empty());
}

INSTANTIATE_TEST_SUITE_P(Transports, Alone, testing::Values(Transport::localhost, Transport::lan));

// 4 s is what every participant of this project announces (participant_qos).
TEST(Participant, TellsTheLeaseOfARemoteWriterAsLongAsItIsThere) {
  Participant one(local()), two(local());
  const EndpointOptions number{
      .topic = "rt/a", .type = "std_msgs::msg::dds_::String_", .qos = {}, .user_data = {}};
  const auto own = one.create_writer(number);
  auto writer = two.create_writer(number);
  const Guid guid = writer->guid();
  EXPECT_TRUE(bw::test::eventually([&] { return one.lease_of(guid).has_value(); }));
  EXPECT_EQ(one.lease_of(guid), Duration::milliseconds(4000));
  EXPECT_EQ(one.lease_of(own->guid()), std::nullopt);
  writer.reset();
  EXPECT_TRUE(bw::test::eventually([&] { return !one.lease_of(guid).has_value(); }));
}

TEST(Participant, ASecondTypeOnATopicIsRefused) {
  Participant participant(local());
  const auto writer = participant.create_writer(
      {.topic = "rt/a", .type = "std_msgs::msg::dds_::String_", .qos = {}, .user_data = {}});
  EXPECT_THROW(participant.create_writer(
                   {.topic = "rt/a", .type = "std_msgs::msg::dds_::Bool_", .qos = {}, .user_data = {}}),
               std::runtime_error);
}

class Environment : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : kNames) {
      if (const char* value = std::getenv(name)) before_[name] = value;
      unsetenv(name);
    }
  }
  void TearDown() override {
    for (const char* name : kNames) unsetenv(name);
    for (const auto& [name, value] : before_) setenv(name.c_str(), value.c_str(), 1);
  }
  static constexpr const char* kNames[] = {"ROS_DOMAIN_ID", "ROS_LOCALHOST_ONLY",
                                           "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_STATIC_PEERS"};

 private:
  std::map<std::string, std::string> before_;
};

TEST_F(Environment, DefaultsToDomainZeroAndTheConfiguredTransport) {
  const Network network = Network::from_environment(Transport::localhost);
  EXPECT_EQ(network.domain_id, 0);
  EXPECT_EQ(network.transport, Transport::localhost);
  EXPECT_EQ(Network::from_environment(Transport::lan).transport, Transport::lan);
}

TEST_F(Environment, FollowsTheVariablesOfRos2) {
  setenv("ROS_DOMAIN_ID", "42", 1);
  setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET", 1);
  setenv("ROS_STATIC_PEERS", "192.0.2.1;192.0.2.7", 1);
  Network network = Network::from_environment(Transport::localhost);
  EXPECT_EQ(network.domain_id, 42);
  EXPECT_EQ(network.transport, Transport::lan);
  EXPECT_EQ(network.static_peers, (std::vector<std::string>{"192.0.2.1", "192.0.2.7"}));
  setenv("ROS_LOCALHOST_ONLY", "1", 1);
  EXPECT_EQ(Network::from_environment(Transport::lan).transport, Transport::localhost);
  setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "nonsense", 1);
  unsetenv("ROS_LOCALHOST_ONLY");
  EXPECT_EQ(Network::from_environment(Transport::lan).transport, Transport::localhost)
      << "an unknown value closes";
}

TEST_F(Environment, RefusesADomainThatIsNone) {
  for (const char* bad : {"x", "-1", "233", "1.5", "1 "}) {
    setenv("ROS_DOMAIN_ID", bad, 1);
    EXPECT_THROW(Network::from_environment(Transport::localhost), std::runtime_error) << bad;
  }
}

}  // namespace
}  // namespace bw::dds
