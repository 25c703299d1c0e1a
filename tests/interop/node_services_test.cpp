// The services that every node has, as ROS 2's tools ask for them, byte by byte. The node `limited` of
// service_graph has one parameter of its own, limits.v_max = 0.75 from 0 to 2, so that most of its answers
// are those worked out in service_golden.hpp; the others are worked out here by the same rules. They are
// those that rclcpp gives every node.
#include <gmock/gmock.h>

#include "tests/interop/eventually.hpp"
#include "tests/interop/service_process.hpp"

namespace bw::test {
namespace {

using plain::from_hex;
using plain::to_hex;

/// Its hashes are those of Jazzy's generator, its bytes are worked out where they are compared.
const Golden kGetTypeDescription{"get_type_description",
                                 "type_description_interfaces/srv/GetTypeDescription",
                                 "470f56ccbcf13d55c78c8b735fb12da03e639e5acded994426c89d94778d9e28",
                                 "648c49d976240861a482f961c5621ddd0d2135d8cce6f297a76d4f6376d93b75",
                                 "",
                                 ""};

const Golden& type_of(const std::string& service) {
  if (service == kGetTypeDescription.service) return kGetTypeDescription;
  return golden_of(service == "get_transition_graph" ? "get_available_transitions" : service);
}

std::string wire_hex(const std::string& hex) { return to_hex(plain::padded(from_hex(hex))); }

class NodeServices : public testing::Test {
 protected:
  NodeServices() : server_("serve"), node_("tool") {}
  ~NodeServices() override { EXPECT_EQ(server_.stop(), 0) << server_.process().err(); }

  /// What /limited answers; nothing when it does not.
  std::string call(const std::string& service, const std::string& request_hex) {
    plain::Client client(node_, "/limited/" + service, plain_type(type_of(service)));
    const auto reply = client.call(from_hex(request_hex));
    return reply ? to_hex(*reply) : "no answer: " + server_.process().err();
  }
  void expect_golden(const std::string& service) {
    EXPECT_EQ(call(service, golden_of(service).request), wire_hex(golden_of(service).response)) << service;
  }

  ServiceProcess server_;
  plain::Node node_;
};

TEST_F(NodeServices, AreThereWithTypesAndHashes) {
  for (const char* name :
       {"get_parameters", "get_parameter_types", "set_parameters", "set_parameters_atomically",
        "describe_parameters", "list_parameters", "get_state", "change_state", "get_available_states",
        "get_available_transitions", "get_transition_graph", "get_type_description"}) {
    const std::string service = std::string("/limited/") + name;
    const Golden& golden = type_of(name);
    ASSERT_TRUE(eventually([&] {
      return node_.count(plain::request_topic(service), false) == 1 &&
             node_.count(plain::reply_topic(service), true) == 1;
    })) << service;
    for (const auto& [gid, end] : node_.ends()) {
      if (end.topic == plain::request_topic(service)) {
        EXPECT_EQ(end.type, plain::request_type(golden.type));
        EXPECT_EQ(end.user_data, "typehash=RIHS01_" + golden.request_hash + ";");
      }
      if (end.topic == plain::reply_topic(service)) {
        EXPECT_EQ(end.type, plain::response_type(golden.type));
        EXPECT_EQ(end.user_data, "typehash=RIHS01_" + golden.response_hash + ";");
      }
    }
  }
}

TEST_F(NodeServices, ParametersAreListedToldAndDescribed) {
  expect_golden("list_parameters");
  expect_golden("get_parameters");
  expect_golden("get_parameter_types");
  expect_golden("describe_parameters");
  // No prefix, any depth: both names, up to 41, and the prefix of one.
  EXPECT_EQ(call("list_parameters", "00010000 00000000 00000000 0000000000000000"),
            wire_hex("00010000 02000000 " + kVMax + "000000" + kUseSimTime +
                     "000000 01000000 07000000 6c696d69747300"));
}

TEST_F(NodeServices, AnUnknownNameMakesTheAnswerEmpty) {
  // ["v"]; the answer is an empty sequence.
  for (const char* service : {"get_parameters", "get_parameter_types", "describe_parameters"})
    EXPECT_EQ(call(service, "00010000 01000000 02000000 7600"), "0001000000000000") << service;
}

TEST_F(NodeServices, AChangeIsMadeAndTold) {
  plain::dds::DataReader* events = node_.create_reader({.topic = "rt/parameter_events",
                                                        .type = "rcl_interfaces::msg::dds_::ParameterEvent_",
                                                        .type_hash = {},
                                                        .depth = 1000});
  ASSERT_TRUE(eventually([&] {
    plain::dds::SubscriptionMatchedStatus writers;
    events->get_subscription_matched_status(writers);
    return writers.current_count > 0;
  }));
  // limits.v_max := 0.5 as in the golden request; the answer [{true, ""}].
  EXPECT_EQ(call("set_parameters", golden_of("set_parameters").request),
            wire_hex("00010000 01000000 01 000000 01000000 00"));
  // get_parameters has 0.5 (3fe0...) where it had 0.75 (3fe8...).
  std::string changed = wire_hex(golden_of("get_parameters").response);
  changed.replace(changed.find("e83f"), 4, "e03f");
  EXPECT_EQ(call("get_parameters", golden_of("get_parameters").request), changed);
  plain::Bytes event;
  plain::dds::SampleInfo info;
  ASSERT_TRUE(
      eventually([&] { return bw::fast_dds::is_ok(events->take_next_sample(&event, &info)); }));
  event.erase(event.begin() + plain::kEncapsulation, event.begin() + plain::kEncapsulation + 8);  // the stamp
  EXPECT_EQ(to_hex(event),
            wire_hex("00010000 09000000 2f6c696d6974656400 "  // of /limited, with the stamp up to 21
                     "000000 00000000 01000000 " +            // 24: none new, one changed
                     kVMax +
                     " 03 00 0000000000 0000000000000000 " +  // 32..51; 56: integer
                     "000000000000e03f 01000000 00 000000 " + kNoArrays + " 00000000"));  // none deleted
  // All or none, and nothing is new.
  expect_golden("set_parameters_atomically");
  node_.remove(events);
}

TEST_F(NodeServices, WhatBreaksARuleIsRefusedInWords) {
  // limits.v_max := 3.0 (4008...); the integer 1, which is of another type.
  const std::string set = "00010000 01000000 " + kVMax;
  const auto reason = [this](const std::string& request) {
    plain::CdrIn cdr(from_hex(call("set_parameters", request)));
    EXPECT_EQ(cdr.number<std::uint32_t>(), 1U);
    EXPECT_EQ(cdr.number<std::uint8_t>(), 0) << "not successful";
    return cdr.text();
  };
  EXPECT_EQ(reason(set + "03 00 00 0000000000000000 0000000000000840 01000000 00 000000" + kNoArrays),
            "limits.v_max = 3.0: must be between 0 and 2");
  EXPECT_EQ(reason(set + "02 00 00 0100000000000000 0000000000000000 01000000 00 000000" + kNoArrays),
            "limits.v_max expects a double, got an integer: write 1.0");
  EXPECT_EQ(call("get_parameters", golden_of("get_parameters").request),
            wire_hex(golden_of("get_parameters").response));
}

TEST_F(NodeServices, TheStateIsToldAndChanged) {
  expect_golden("get_state");  // 3, active
  // deactivate (4 -> 14), shutdown (7 -> 12), the ids and labels of lifecycle_msgs.
  EXPECT_EQ(call("get_available_transitions", "00010000 00"),
            wire_hex("00010000 02000000 04 000000 0b000000 6465616374697661746500 "  // 8, up to 23
                     "03 07000000 61637469766500 "                                   // 24, up to 35
                     "0e 0d000000 646561637469766174696e6700 "                       // 36, up to 53
                     "07 0000 09000000 73687574646f776e00 "                          // 56, up to 69
                     "03 0000 07000000 61637469766500 "                              // 72, up to 83
                     "0c 0d000000 7368757474696e67646f776e00"));                     // 84
  EXPECT_EQ(call("change_state", golden_of("change_state").request), wire_hex("00010000 00"))
      << "active already";
  // {4, ""}: without a label the id decides; then inactive is 2.
  EXPECT_EQ(call("change_state", "00010000 04 000000 01000000 00"), wire_hex("00010000 01"));
  EXPECT_EQ(call("get_state", "00010000 00"), wire_hex("00010000 02 000000 09000000 696e61637469766500"));
  expect_golden("get_parameters");  // answered in every state
  expect_golden("change_state");
  expect_golden("get_state");
  // An unknown label is refused whatever the id says: {4, "stop"}.
  EXPECT_EQ(call("change_state", "00010000 04 000000 05000000 73746f7000"), wire_hex("00010000 00"));
  expect_golden("get_state");
}

std::string type_request(const std::string& hash, bool with_sources = false) {
  return to_hex(plain::CdrOut().text("").text(hash).number(static_cast<std::uint8_t>(with_sources)).bytes());
}

// Of GetState_Request, which is an empty message and so one uint8 (type 3).
TEST_F(NodeServices, TheTypesOfANodeAreDescribedByTheirHashes) {
  const std::string hash = "RIHS01_" + golden_of("get_state").request_hash;
  plain::CdrOut expected;
  expected.number(std::uint8_t{1}).text("").text("lifecycle_msgs/srv/GetState_Request");
  expected.number(1U).text("structure_needs_at_least_one_member").number(std::uint8_t{3});
  expected.number(std::uint64_t{0})
      .number(std::uint64_t{0})
      .text("")
      .text("");                              // capacities, nested type, default
  expected.number(0U).number(0U).number(0U);  // refers to none; no sources; nothing extra
  EXPECT_EQ(call("get_type_description", type_request(hash)), to_hex(plain::padded(expected.bytes())));
}

// Log: every node has /rosout, as in rclcpp, though one writer of the process serves them all. Trigger is a
// service of another node of this process. The last one is a hash as rmw_zenoh has it of the whole service
// (type_description_messages_test.cpp).
TEST_F(NodeServices, WhatANodeDoesNotUseIsRefusedAtOnceAndInWords) {
  const auto is_told = [this](const std::string& hash) {
    return plain::CdrIn(from_hex(call("get_type_description", type_request(hash, true))))
        .number<std::uint8_t>();
  };
  EXPECT_EQ(is_told("RIHS01_e28ce254ca8abc06abf92773b74602cdbf116ed34fbaf294fb9f81da9f318eac"), 1);  // Log
  const auto reason = [this](const std::string& hash) {
    plain::CdrIn cdr(from_hex(call("get_type_description", type_request(hash))));
    EXPECT_EQ(cdr.number<std::uint8_t>(), 0) << "not successful";
    return cdr.text();
  };
  EXPECT_EQ(reason("RIHS01_eeff2cd6fa5ad9d27cdf4dec64818317839b62f212a91e6b5304b634b2062c5f"),
            "this node uses no type of that hash");
  EXPECT_EQ(reason("std_srvs/srv/Trigger"), "type_hash is no hash: RIHS01_ and 64 hexadecimal digits");
}

TEST_F(NodeServices, AWholeServiceHasAHashToo) {
  plain::Client client(node_, "/server/get_type_description", plain_type(kGetTypeDescription));
  const auto reply = client.call(
      from_hex(type_request("RIHS01_eeff2cd6fa5ad9d27cdf4dec64818317839b62f212a91e6b5304b634b2062c5f")));
  ASSERT_TRUE(reply) << server_.process().err();
  plain::CdrIn cdr(*reply);
  EXPECT_EQ(cdr.number<std::uint8_t>(), 1);
  EXPECT_EQ(cdr.text(), "");
  EXPECT_EQ(cdr.text(), "std_srvs/srv/Trigger");
}

TEST_F(NodeServices, ARequestThatIsNoneChangesNothing) {
  // Refused in the form of the service: not successful, with the reason where there is a place for one.
  EXPECT_EQ(call("change_state", "00010000 04"), wire_hex("00010000 00"));
  plain::CdrIn cdr(from_hex(call("set_parameters_atomically", "00010000 ffffffff")));
  EXPECT_EQ(cdr.number<std::uint8_t>(), 0);
  EXPECT_EQ(cdr.text(), "the request holds no rcl_interfaces/srv/SetParametersAtomically");
  expect_golden("get_state");
}

}  // namespace
}  // namespace bw::test
