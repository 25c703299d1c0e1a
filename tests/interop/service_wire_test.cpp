// Our services and clients as another program sees them on the wire, byte by byte: plain::Node follows
// rmw_fastrtps by the letter and shares no code with this project. Expected values: service_golden.hpp, rmw's
// profiles, rmw_fastrtps's use of the sample identity.
#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>

#include "tests/interop/eventually.hpp"
#include "tests/interop/on_the_wire.hpp"
#include "tests/interop/service_process.hpp"

namespace bw::test {
namespace {

using plain::to_hex;
using testing::SizeIs;

void expect_end(const plain::End& end, const std::string& type, const std::string& hash) {
  EXPECT_EQ(end.type, type);
  EXPECT_EQ(end.user_data, "typehash=RIHS01_" + hash + ";") << end.topic;
  EXPECT_TRUE(end.is_reliable) << end.topic;
  EXPECT_TRUE(end.is_volatile) << end.topic;
}

std::string underscored(const std::string& type, const std::string& suffix) {
  const std::size_t slash = type.find('/');
  return type.substr(0, slash) + "::srv::dds_::" + type.substr(type.rfind('/') + 1) + suffix;
}

class ServerOnTheWire : public testing::Test {
 protected:
  static void SetUpTestSuite() { server_ = std::make_unique<ServiceProcess>("serve"); }
  static void TearDownTestSuite() {
    EXPECT_EQ(server_->stop(), 0) << server_->process().err();
    server_.reset();
  }
  static std::unique_ptr<ServiceProcess> server_;
};

std::unique_ptr<ServiceProcess> ServerOnTheWire::server_;

TEST_F(ServerOnTheWire, EndsHaveTheNamesTypesQosAndHashesOfRos2) {
  plain::Node node("look");
  for (const Golden& entry : golden()) {
    const std::string service = "/example/" + entry.service;
    ASSERT_TRUE(eventually([&] {
      return node.count("rq" + service + "Request", false) == 1 &&
             node.count("rr" + service + "Reply", true) == 1;
    })) << service;
    expect_end(foreign_end(node, "rq" + service + "Request", false).second,
               underscored(entry.type, "_Request_"), entry.request_hash);
    expect_end(foreign_end(node, "rr" + service + "Reply", true).second,
               underscored(entry.type, "_Response_"), entry.response_hash);
  }
}

TEST_F(ServerOnTheWire, TheNodeListsItsRequestReaderAndReplyWriter) {
  plain::Node node("look");
  ASSERT_TRUE(eventually([&] {  // readers and writers are discovered apart
    return node.count("rr/example/triggerReply", true) == 1 &&
           node.count("rq/example/triggerRequest", false) == 1;
  }));
  const plain::Gid reader = foreign_end(node, "rq/example/triggerRequest", false).first;
  const plain::Gid writer = foreign_end(node, "rr/example/triggerReply", true).first;
  ASSERT_TRUE(eventually([&] {
    return std::ranges::any_of(node.nodes(),
                               [](const plain::NodeInfo& info) { return info.name == "/server"; });
  }));
  for (const plain::NodeInfo& info : node.nodes()) {
    EXPECT_EQ(info.readers.contains(reader), info.name == "/server") << info.name;
    EXPECT_EQ(info.writers.contains(writer), info.name == "/server") << info.name;
  }
}

TEST_F(ServerOnTheWire, EachRequestGetsTheBytesOfItsResponse) {
  plain::Node node("ask");
  for (const Golden& entry : golden()) {
    plain::Client client(node, "/example/" + entry.service, plain_type(entry));
    const auto reply = client.call(plain::from_hex(entry.request));
    ASSERT_TRUE(reply.has_value()) << entry.service;
    EXPECT_EQ(to_hex(*reply), wire_hex(entry.response)) << entry.service;
  }
}

TEST_F(ServerOnTheWire, AReplyCarriesTheClientsReaderAndTheCountOfTheRequest) {
  const auto wire = std::make_shared<plain::Wire>();
  plain::Node node("ask", wire);
  const Golden& trigger = golden_of("trigger");
  plain::Client client(node, "/example/trigger", plain_type(trigger));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(client.call(plain::from_hex(trigger.request)).has_value());
  const plain::Gid writer = foreign_end(node, "rr/example/triggerReply", true).first;
  std::map<std::int64_t, plain::Data> replies;  // without those that were sent again
  for (plain::Data& data : wire->data_of(writer)) replies.emplace(data.sequence, std::move(data));
  ASSERT_THAT(replies, SizeIs(3));
  std::uint32_t sequence = 0;
  for (const auto& [own_sequence, data] : replies) {
    ASSERT_TRUE(data.inline_qos.contains(kRelatedIdentity));
    EXPECT_EQ(to_hex(data.inline_qos.at(kRelatedIdentity)),
              to_hex(identity_bytes(plain::to_gid(client.reader().guid()), 0, ++sequence)));
    EXPECT_EQ(to_hex(data.payload), wire_hex(trigger.response)) << "nothing but the response in the payload";
  }
}

TEST_F(ServerOnTheWire, ClientsOfEachKindOfIdentityAreAnswered) {
  plain::Node node("ask");
  const Golden& trigger = golden_of("trigger");
  using enum plain::Client::Identity;
  for (const plain::Client::Identity identity : {reply_reader, request_writer, unknown}) {
    plain::Client client(node, "/example/trigger", plain_type(trigger), identity);
    const auto reply = client.call(plain::from_hex(trigger.request));
    ASSERT_TRUE(reply.has_value()) << static_cast<int>(identity);
    EXPECT_EQ(to_hex(*reply), wire_hex(trigger.response));
  }
}

TEST_F(ServerOnTheWire, EveryClientSeesAllRepliesAndKnowsItsOwn) {
  plain::Node node("ask"), other_node("other");
  const Golden& trigger = golden_of("trigger");
  plain::Client client(node, "/example/trigger", plain_type(trigger));
  plain::Client other(other_node, "/example/trigger", plain_type(trigger));
  // Answered once, it is connected in both directions.
  ASSERT_TRUE(other.call(plain::from_hex(trigger.request)).has_value());
  ASSERT_TRUE(eventually([&] { return client.is_ready(); }));
  const std::int64_t asked = client.send(plain::from_hex(trigger.request));
  // Both counts are 1: only the identity tells whose reply it is.
  EXPECT_FALSE(other.take(asked).has_value());
  ASSERT_TRUE(eventually([&] {
    EXPECT_FALSE(other.take(asked).has_value());
    return other.foreign_replies() == 1;
  }));
  EXPECT_TRUE(eventually([&] { return client.take(asked).has_value(); }));
}

TEST_F(ServerOnTheWire, ADeferredReplyComesLaterAndInBetweenOthersAreAnswered) {
  plain::Node node("ask");
  const Golden& trigger = golden_of("trigger");
  plain::Client kept(node, "/kept", plain_type(trigger)), count(node, "/count", plain_type(trigger)),
      release(node, "/release", plain_type(trigger));
  ASSERT_TRUE(eventually([&] { return kept.is_ready(); }));
  const std::int64_t first = kept.send(plain::from_hex(trigger.request));
  const std::int64_t second = kept.send(plain::from_hex(trigger.request));
  ASSERT_TRUE(count.call(plain::from_hex(trigger.request)).has_value());
  EXPECT_FALSE(kept.take(first).has_value());
  // {true, "2"} and {true, "released"}
  std::optional<plain::Bytes> released;
  ASSERT_TRUE(eventually([&] {
    released = release.call(plain::from_hex(trigger.request));
    return !released || to_hex(*released) == wire_hex("00010000 01 000000 02000000 3200");
  }));
  ASSERT_TRUE(released.has_value());
  for (const std::int64_t asked : {second, first}) {
    std::optional<plain::Bytes> reply;
    ASSERT_TRUE(eventually([&] { return (reply = kept.take(asked)).has_value(); }));
    EXPECT_EQ(to_hex(*reply), wire_hex("00010000 01 000000 09000000 72656c656173656400"));
  }
}

TEST_F(ServerOnTheWire, AReplyWaitsForAReaderThatComesAfterTheRequest) {
  // The request names a reader that does not exist yet: its entity id is chosen by hand.
  plain::Node node("ask");
  const Golden& trigger = golden_of("trigger");
  constexpr int kReader = 0x1234;
  plain::Client ready(node, "/example/trigger", plain_type(trigger));
  ASSERT_TRUE(eventually([&] { return ready.is_ready(); }));
  plain::rtps::GUID_t future = node.guid();
  future.entityId = plain::rtps::EntityId_t(kReader << 8U | 0x04U);
  plain::rtps::WriteParams params;
  params.related_sample_identity().writer_guid(future);
  plain::Bytes request = plain::from_hex(trigger.request);
  ASSERT_TRUE(bw::fast_dds::write(ready.writer(), &request, params));
  plain::dds::DataReader* reader = node.create_reader({.topic = plain::reply_topic("/example/trigger"),
                                                       .type = plain::response_type(trigger.type),
                                                       .type_hash = {},
                                                       .entity_id = kReader});
  ASSERT_EQ(reader->guid(), future);
  plain::Bytes reply;
  plain::dds::SampleInfo info;
  EXPECT_TRUE(
      eventually([&] { return bw::fast_dds::is_ok(reader->take_next_sample(&reply, &info)); }));
  EXPECT_EQ(info.related_sample_identity.writer_guid(), future);
  EXPECT_EQ(to_hex(reply), wire_hex(trigger.response));
  node.remove(reader);
}

class ClientOnTheWire : public testing::Test {
 protected:
  /// Answers what `caller` asks of each example until it has ended; the bytes of the requests by service.
  std::map<std::string, std::vector<plain::Request>> serve(plain::Node& node, ServiceProcess& caller) {
    std::map<std::string, std::unique_ptr<plain::Server>> servers;
    for (const Golden& entry : golden())
      servers[entry.service] =
          std::make_unique<plain::Server>(node, "/plain/" + entry.service, plain_type(entry));
    std::map<std::string, std::vector<plain::Request>> requests;
    EXPECT_TRUE(eventually([&] {
      for (const Golden& entry : golden()) {
        while (const auto request = servers[entry.service]->take()) {
          requests[entry.service].push_back(*request);
          EXPECT_TRUE(servers[entry.service]->reply(request->from, plain::from_hex(entry.response)));
        }
      }
      return !caller.process().running();
    })) << caller.process().out()
        << caller.process().err();
    return requests;
  }
};

TEST_F(ClientOnTheWire, EachRequestAndWhatIsReadOfItsReplyAreTheBytesOfRos2) {
  const auto wire = std::make_shared<plain::Wire>();
  plain::Node node("plain", wire);
  ServiceProcess caller("call");
  const auto requests = serve(node, caller);
  std::ostringstream expected;
  for (const Golden& entry : golden()) {
    ASSERT_THAT(requests.at(entry.service), SizeIs(1)) << entry.service;
    EXPECT_EQ(to_hex(requests.at(entry.service)[0].bytes), wire_hex(entry.request)) << entry.service;
    expected << entry.service << " " << to_hex(plain::from_hex(entry.response)) << "\n";
  }
  std::istringstream printed(caller.process().out());
  std::set<std::string> lines;
  for (std::string line; std::getline(printed, line);) lines.insert(line);
  std::istringstream wanted(expected.str());
  for (std::string line; std::getline(wanted, line);) EXPECT_THAT(lines, testing::Contains(line));
  EXPECT_EQ(caller.process().wait(std::chrono::seconds(20)), 0) << caller.process().err();
}

TEST_F(ClientOnTheWire, ARequestNamesTheReplyReaderAndNoSequenceNumber) {
  const auto wire = std::make_shared<plain::Wire>();
  plain::Node node("plain", wire);
  ServiceProcess caller("call");
  // Discovery as it was while the caller ran.
  std::map<plain::Gid, plain::End> ends;
  plain::Server trigger(node, "/plain/trigger", plain_type(golden_of("trigger")));
  std::optional<plain::Request> request;
  ASSERT_TRUE(eventually([&] { return (request = trigger.take()).has_value(); }));
  const auto [reader, reader_end] = foreign_end(node, "rr/plain/triggerReply", false);
  const auto [writer, writer_end] = foreign_end(node, "rq/plain/triggerRequest", true);
  expect_end(reader_end, "std_srvs::srv::dds_::Trigger_Response_", golden_of("trigger").response_hash);
  expect_end(writer_end, "std_srvs::srv::dds_::Trigger_Request_", golden_of("trigger").request_hash);
  EXPECT_EQ(plain::to_gid(request->writer), writer);
  EXPECT_EQ(plain::to_gid(request->related), reader);
  const auto data = wire->data_of(writer);
  ASSERT_FALSE(data.empty());
  ASSERT_TRUE(data[0].inline_qos.contains(kRelatedIdentity));
  // SEQUENCENUMBER_UNKNOWN: high word -1, low word 0.
  EXPECT_EQ(to_hex(data[0].inline_qos.at(kRelatedIdentity)), to_hex(identity_bytes(reader, 0xffffffffU, 0)));
  ASSERT_TRUE(eventually([&] {
    return std::ranges::any_of(node.nodes(), [&](const plain::NodeInfo& info) {
      return info.name == "/caller" && info.readers.contains(reader) && info.writers.contains(writer);
    });
  }));
}

TEST_F(ClientOnTheWire, ARequestWaitsForTheOtherHalfOfItsServer) {
  plain::Node node("plain");
  const Golden& trigger = golden_of("trigger");
  plain::Server half(node, "/plain/trigger", plain_type(trigger), true);
  ServiceProcess caller("call");
  plain::Node look("look");
  // The caller's writer is connected to the half that is there: nothing may come.
  ASSERT_TRUE(eventually([&] { return half.connected_writers() == 1; }));
  EXPECT_FALSE(half.take().has_value());
  half.complete();
  std::optional<plain::Request> request;
  ASSERT_TRUE(eventually([&] { return (request = half.take()).has_value(); }))
      << "nobody told the client that its server is whole";
  EXPECT_TRUE(half.reply(request->from, plain::from_hex(trigger.response)));
  EXPECT_TRUE(eventually([&] {
    return caller.process().out().find("trigger " + to_hex(plain::from_hex(trigger.response))) !=
           std::string::npos;
  }));
}

}  // namespace
}  // namespace bw::test
