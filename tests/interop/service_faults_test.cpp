// What strangers do to our services: requests that are none, clients that die, floods of clients, of
// participants and of requests. After each the server answers everybody else, and its memory is bounded. The
// client shares no code with this project (plain::Node).
#include <cstdlib>

#include <gmock/gmock.h>

#include "tests/interop/eventually.hpp"
#include "tests/interop/service_process.hpp"

namespace bw::test {
namespace {

using plain::from_hex;
using plain::to_hex;
using testing::HasSubstr;

/// How many of something: few in CTest, or as the variable says.
int count_of(const char* variable, int few) {
  const char* text = std::getenv(variable);
  return text == nullptr ? few : std::atoi(text);
}

const plain::Bytes& trigger_request() {
  static const plain::Bytes bytes = from_hex(golden_of("trigger").request);
  return bytes;
}

class ServiceFaults : public testing::Test {
 protected:
  ServiceFaults() : server_("serve"), node_("stranger") {}

  static plain::ServiceType trigger() { return plain_type(golden_of("trigger")); }
  /// A whole call of a newcomer.
  void expect_alive() {
    plain::Node newcomer("newcomer");
    plain::Client client(newcomer, "/example/trigger", trigger());
    const auto reply = client.call(trigger_request());
    ASSERT_TRUE(reply.has_value()) << server_.process().err();
    EXPECT_EQ(to_hex(*reply), to_hex(plain::padded(from_hex(golden_of("trigger").response))));
  }
  /// Sanitizers keep memory of their own.
  static void expect_below(double used_mb, double allowed_mb, const std::string& what) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LT(used_mb, allowed_mb) << "MB " << what;
#else
    RecordProperty("memory_mb_sanitized " + what, std::to_string(used_mb - allowed_mb));
#endif
  }
  void expect_ends_well() { EXPECT_EQ(server_.stop(), 0) << server_.process().err(); }

  ServiceProcess server_;
  plain::Node node_;
};

/// What no reader of CDR may trust, by name.
const std::map<std::string, std::string>& hostile_requests() {
  static const std::map<std::string, std::string> all = {
      {"nothing", ""},
      {"half an encapsulation", "0001"},
      {"only an encapsulation", "00010000"},
      {"parameter list encapsulation", "00030000 01000000 07000000 6c696d69747300 00 0100000000000000"},
      {"XCDR2", "00070000 01000000 07000000 6c696d69747300 00 01000000 00000000"},
      {"no encapsulation that exists", "ffff0000 01000000 07000000 6c696d69747300 00 0100000000000000"},
      {"cut in its last number", "00010000 01000000 07000000 6c696d69747300 00 01000000"},
      {"four milliards of names", "00010000 ffffffff 07000000 6c696d69747300 00 0100000000000000"},
      {"a name of 2 GiB", "00010000 01000000 ffffff7f 6c696d69747300 00 0100000000000000"},
      {"a name without its end", "00010000 01000000 06000000 6c696d697473 0000 0100000000000000"},
  };
  return all;
}

TEST_F(ServiceFaults, ARequestThatIsNoneIsNamedInTheLogAndCostsOthersNothing) {
  const Golden& list = golden_of("list_parameters");
  plain::Client client(node_, "/example/list_parameters", plain_type(list),
                       plain::Client::Identity::reply_reader, 1000);
  ASSERT_TRUE(eventually([&] { return client.is_ready(); }));
  std::vector<std::int64_t> asked;
  for (const auto& [name, hex] : hostile_requests()) asked.push_back(client.send(from_hex(hex)));
  // Requests of one client are answered in their order: behind this reply comes none to those.
  const auto reply = client.call(from_hex(list.request));
  ASSERT_TRUE(reply.has_value()) << server_.process().err();
  EXPECT_EQ(to_hex(*reply), to_hex(plain::padded(from_hex(list.response))));
  for (const std::int64_t sequence : asked) EXPECT_FALSE(client.take(sequence).has_value()) << sequence;
  EXPECT_THAT(
      server_.process().err(),
      HasSubstr("[server] a request of /example/list_parameters holds no rcl_interfaces/srv/ListParameters"));
  expect_ends_well();
}

TEST_F(ServiceFaults, WhatChangesSomethingRefusesARequestThatIsNoneInWords) {
  plain::Client client(node_, "/switch", plain_type(golden_of("set_bool")));
  const auto reply = client.call(from_hex("00010000"));
  ASSERT_TRUE(reply.has_value());
  plain::CdrIn cdr(*reply);
  EXPECT_EQ(cdr.number<std::uint8_t>(), 0) << "no success";
  EXPECT_EQ(cdr.text(), "the request holds no std_srvs/srv/SetBool");
  expect_ends_well();
}

TEST_F(ServiceFaults, BigEndianRequestsAreRead) {
  // true, in the other byte order; the answer is {true, "on"}.
  plain::Client client(node_, "/switch", plain_type(golden_of("set_bool")));
  const auto reply = client.call(from_hex("00000000 01"));
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(to_hex(*reply), to_hex(plain::padded(from_hex("00010000 01 000000 03000000 6f6e00"))));
  expect_ends_well();
}

TEST_F(ServiceFaults, AReplyThatNobodyWaitsForIsDropped) {
  {
    plain::Client leaving(node_, "/kept", trigger());
    ASSERT_TRUE(eventually([&] { return leaving.is_ready(); }));
    leaving.send(trigger_request());
    plain::Client count(node_, "/example/trigger", trigger());
    ASSERT_TRUE(count.call(trigger_request()).has_value()) << "the request before is in the server";
  }
  {
    auto dying = std::make_unique<plain::Node>("dying");
    plain::Client client(*dying, "/kept", trigger());
    ASSERT_TRUE(eventually([&] { return client.is_ready(); }));
    client.send(trigger_request());
    plain::Client count(*dying, "/example/trigger", trigger());
    ASSERT_TRUE(count.call(trigger_request()).has_value());
  }
  plain::Client release(node_, "/release", trigger());
  const auto released = release.call(trigger_request());
  ASSERT_TRUE(released.has_value());
  EXPECT_EQ(to_hex(*released), to_hex(plain::padded(from_hex("00010000 01 000000 02000000 3200")))) << "both";
  expect_alive();
  expect_ends_well();
}

TEST_F(ServiceFaults, AKilledClientIsForgotten) {
  // Two processes die between request and reply; discovery holds them for alive some seconds more.
  for (int i = 0; i < 2; ++i) {
    Process client({PLAIN_CLIENT, "/kept", "std_srvs/srv/Trigger", "0001000000"});
    ASSERT_TRUE(eventually([&] { return client.out() == "asked\n"; }));
    client.signal(SIGKILL);
    ASSERT_TRUE(client.wait(std::chrono::seconds(10)).has_value());
  }
  plain::Client release(node_, "/release", trigger());
  ASSERT_TRUE(release.call(trigger_request()).has_value());
  expect_alive();
  expect_ends_well();
}

TEST_F(ServiceFaults, RepliesToReadersThatNeverComeAreBounded) {
  // Each names a reader that does not exist: the server holds the reply for a while, 256 of them at most.
  constexpr int kGhosts = 2000;
  plain::Client client(node_, "/example/trigger", trigger(), plain::Client::Identity::reply_reader, 1000);
  ASSERT_TRUE(client.call(trigger_request()).has_value());
  const double before = server_.memory_mb();
  plain::rtps::GUID_t ghost = node_.guid();
  for (int i = 0; i < kGhosts; ++i) {
    ghost.entityId = plain::rtps::EntityId_t((0x4000U + static_cast<unsigned>(i)) << 8U | 0x04U);
    plain::rtps::WriteParams params;
    params.related_sample_identity().writer_guid(ghost);
    plain::Bytes request = trigger_request();
    ASSERT_TRUE(bw::fast_dds::write(client.writer(), &request, params));
    if (i % 50 == 0) {
      ASSERT_TRUE(client.call(trigger_request()).has_value());
    }
  }
  expect_below(server_.memory_mb() - before, 5.0, "for replies to nobody");
  expect_alive();
  expect_ends_well();
}

TEST_F(ServiceFaults, ManyClientsOfOneParticipantAreAllAnswered) {
  const int clients = count_of("BANDWAGON_SERVICE_CLIENTS", 200);
  // Each is two ends that the server knows with all they announce, and is connected to: measured 31 kB.
  const double allowed_mb = 10.0 + 0.05 * clients;
  expect_alive();
  const double before = server_.memory_mb();
  for (int round = 0; round < 2; ++round) {
    plain::Node crowd("crowd");
    std::vector<std::unique_ptr<plain::Client>> all;
    for (int i = 0; i < clients; ++i)
      all.push_back(std::make_unique<plain::Client>(crowd, "/example/trigger", trigger()));
    for (int i = 0; i < clients; ++i) {
      const auto reply = all[static_cast<std::size_t>(i)]->call(trigger_request(), std::chrono::seconds(60));
      ASSERT_TRUE(reply.has_value()) << "client " << i << " in round " << round << server_.process().err();
    }
    const double used = server_.memory_mb() - before;
    RecordProperty("memory_mb_" + std::to_string(round), std::to_string(used));
    expect_below(used, allowed_mb, "round " + std::to_string(round));
  }
  expect_alive();
  expect_ends_well();
}

TEST_F(ServiceFaults, ManyParticipantsOneAfterAnotherLeaveNothing) {
  const int participants = count_of("BANDWAGON_SERVICE_PARTICIPANTS", 30);
  expect_alive();
  double first = 0.0;
  for (int i = 0; i < participants; ++i) {
    plain::Node node("guest");
    plain::Client client(node, "/example/trigger", trigger());
    ASSERT_TRUE(client.call(trigger_request(), std::chrono::seconds(30)).has_value()) << "participant " << i;
    if (i == 9) first = server_.memory_mb();
  }
  const double grown = server_.memory_mb() - first;
  RecordProperty("memory_mb", std::to_string(grown));
  expect_below(grown, 5.0, "more than after the tenth");
  expect_ends_well();
}

TEST_F(ServiceFaults, ManyRequestsOfOneClientAreAllAnsweredInTheirOrder) {
  // {true, "N"} tells the place of each in the server's order.
  constexpr int kRequests = 5000, kUnderWay = 100;
  plain::Client client(node_, "/count", trigger(), plain::Client::Identity::reply_reader, 1000);
  ASSERT_TRUE(eventually([&] { return client.is_ready(); }));
  std::map<std::int64_t, int> open;
  int sent = 0, answered = 0;
  ASSERT_TRUE(eventually([&] {
    while (sent < kRequests && open.size() < kUnderWay) open[client.send(trigger_request())] = ++sent;
    for (auto next = open.begin(); next != open.end();) {
      const auto reply = client.take(next->first);
      if (!reply) break;
      plain::CdrIn cdr(*reply);
      EXPECT_EQ(cdr.number<std::uint8_t>(), 1);
      EXPECT_EQ(cdr.text(), std::to_string(next->second));
      next = open.erase(next);
      ++answered;
    }
    return answered == kRequests;
  })) << answered
      << " of " << kRequests;
  expect_ends_well();
}

TEST_F(ServiceFaults, AClientOfAnotherTypeHearsNothingAndDisturbsNobody) {
  // DDS connects equal types alone, as ROS 2 does: the stranger waits for its service to become available.
  plain::Client stranger(node_, "/example/trigger", plain_type(golden_of("set_bool")));
  plain::Node other("other");
  plain::Client client(other, "/example/trigger", trigger());
  ASSERT_TRUE(client.call(trigger_request()).has_value());
  EXPECT_FALSE(stranger.is_ready());
  expect_alive();
  expect_ends_well();
}

TEST_F(ServiceFaults, ATimerOfTheServerRunsWhileRequestsFlood) {
  // `later` is answered by a timer of the same component, on the same lane as the flood.
  plain::Client flood(node_, "/count", trigger(), plain::Client::Identity::reply_reader, 1000);
  plain::Client later(node_, "/later", trigger());
  ASSERT_TRUE(eventually([&] { return flood.is_ready() && later.is_ready(); }));
  for (int round = 0; round < 3; ++round) {
    const std::int64_t asked = later.send(trigger_request());
    std::optional<plain::Bytes> reply;
    std::int64_t last = 0;
    ASSERT_TRUE(eventually([&] {
      for (int i = 0; i < 200; ++i) last = flood.send(trigger_request());
      return (reply = later.take(asked)).has_value();
    }));
    EXPECT_EQ(to_hex(*reply), to_hex(plain::padded(from_hex("00010000 01 000000 06000000 6c6174657200"))));
    flood.take(last);
  }
  expect_alive();
  expect_ends_well();
}

}  // namespace
}  // namespace bw::test
