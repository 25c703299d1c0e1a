// Every op and opcode that a client sends, well formed and not. Bytes are written down from the documented
// layouts.
#include "runtime/remote/foxglove/client_ops.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace bw::foxglove {
namespace {

using Kind = ProtocolError::Kind;

template <class Op>
Op text_op(std::string_view text) {
  const auto decoded = decode_text(text);
  if (const auto* error = std::get_if<ProtocolError>(&decoded)) {
    ADD_FAILURE() << error->message;
    return {};
  }
  const Op* op = std::get_if<Op>(&std::get<TextOp>(decoded));
  EXPECT_NE(op, nullptr) << "another op than expected";
  return op == nullptr ? Op{} : *op;
}

void expect_refused(std::string_view text, Kind kind, const std::string& message) {
  const auto decoded = decode_text(text);
  const auto* error = std::get_if<ProtocolError>(&decoded);
  ASSERT_NE(error, nullptr) << text.substr(0, 100) << " is taken";
  EXPECT_EQ(error->kind, kind) << error->message;
  EXPECT_EQ(error->message, message);
}

using Raw = std::vector<std::uint8_t>;

template <class Op>
Op binary_op(const Raw& bytes, Subprotocol subprotocol) {
  const auto decoded = decode_binary(bytes, subprotocol);
  if (const auto* error = std::get_if<ProtocolError>(&decoded)) {
    ADD_FAILURE() << error->message;
    return {};
  }
  const Op* op = std::get_if<Op>(&std::get<BinaryOp>(decoded));
  EXPECT_NE(op, nullptr) << "another opcode than expected";
  return op == nullptr ? Op{} : *op;
}

void expect_refused(const Raw& bytes, Subprotocol subprotocol, Kind kind, const std::string& message) {
  const auto decoded = decode_binary(bytes, subprotocol);
  const auto* error = std::get_if<ProtocolError>(&decoded);
  ASSERT_NE(error, nullptr) << testing::PrintToString(bytes) << " is taken";
  EXPECT_EQ(error->kind, kind) << error->message;
  EXPECT_EQ(error->message, message);
}

constexpr Subprotocol kBoth[] = {Subprotocol::websocket_v1, Subprotocol::sdk_v1};

TEST(ClientText, Subscriptions) {
  const auto op = text_op<Subscribe>(
      R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":3},{"id":4294967295,"channelId":5}]})");
  ASSERT_EQ(op.subscriptions.size(), 2U);
  EXPECT_EQ(op.subscriptions[0].id, 0U);
  EXPECT_EQ(op.subscriptions[0].channel, 3U);
  EXPECT_EQ(op.subscriptions[1].id, 4294967295U);
  EXPECT_EQ(op.subscriptions[1].channel, 5U);
  EXPECT_EQ(text_op<Unsubscribe>(R"({"op":"unsubscribe","subscriptionIds":[0,1]})").subscriptions,
            (std::vector<std::uint32_t>{0, 1}));
}

TEST(ClientText, ChannelsWithAndWithoutSchema) {
  const auto op = text_op<Advertise>(
      R"({"op":"advertise","channels":[{"id":1,"topic":"/goal_pose","encoding":"json","schemaName":"geometry_msgs/PoseStamped"},
          {"id":2,"topic":"/cmd","encoding":"cdr","schemaName":"geometry_msgs/msg/Twist","schema":"Vector3 linear","schemaEncoding":"ros2msg"}]})");
  ASSERT_EQ(op.channels.size(), 2U);
  EXPECT_EQ(op.channels[0].id, 1U);
  EXPECT_EQ(op.channels[0].topic, "/goal_pose");
  EXPECT_EQ(op.channels[0].encoding, "json");
  EXPECT_EQ(op.channels[0].schema_name, "geometry_msgs/PoseStamped");
  EXPECT_EQ(op.channels[1].schema_name, "geometry_msgs/msg/Twist");
  EXPECT_EQ(text_op<Unadvertise>(R"({"op":"unadvertise","channelIds":[7]})").channels,
            (std::vector<std::uint32_t>{7}));
}

TEST(ClientText, Parameters) {
  const auto get =
      text_op<GetParameters>(R"({"op":"getParameters","parameterNames":["/a.b"],"id":"get-all-params"})");
  EXPECT_EQ(get.names, std::vector<std::string>{"/a.b"});
  EXPECT_EQ(get.request, "get-all-params");
  EXPECT_EQ(text_op<GetParameters>(R"({"op":"getParameters","parameterNames":[]})").request, std::nullopt);

  const auto set = text_op<SetParameters>(
      R"({"op":"setParameters","id":"7","parameters":[{"name":"/a.i","value":3},{"name":"/a.d","value":3,"type":"float64"},{"name":"/a.gone"}]})");
  EXPECT_EQ(set.parameters,
            (std::vector<NamedValue>{{"/a.i", std::int64_t{3}}, {"/a.d", 3.0}, {"/a.gone", {}}}));
  EXPECT_EQ(set.request, "7");
  EXPECT_EQ(
      text_op<SubscribeParameterUpdates>(R"({"op":"subscribeParameterUpdates","parameterNames":["/x"]})")
          .names,
      std::vector<std::string>{"/x"});
  EXPECT_TRUE(
      text_op<UnsubscribeParameterUpdates>(R"({"op":"unsubscribeParameterUpdates","parameterNames":[]})")
          .names.empty());
}

TEST(ClientText, GraphAndAssets) {
  text_op<SubscribeConnectionGraph>(R"({"op":"subscribeConnectionGraph"})");
  text_op<UnsubscribeConnectionGraph>(R"({"op":"unsubscribeConnectionGraph"})");
  const auto asset =
      text_op<FetchAsset>(R"({"op":"fetchAsset","uri":"package://foo/robot.urdf","requestId":123})");
  EXPECT_EQ(asset.uri, "package://foo/robot.urdf");
  EXPECT_EQ(asset.request, 123U);
}

TEST(ClientText, WhatIsNoOpIsRefused) {
  expect_refused("", Kind::not_json, "a text that is not JSON");
  expect_refused("{\"op\":", Kind::not_json, "a text that is not JSON");
  expect_refused("{\"op\":\"\xff\"}", Kind::not_json, "a text that is not JSON");  // no UTF-8
  expect_refused(R"({"op":"subscribe","subscriptions":[{"id":1e999,"channelId":1}]})", Kind::not_json,
                 "a text that is not JSON");  // no double holds it
  expect_refused("[]", Kind::no_op, "a text without a field op that is a string");
  expect_refused("7", Kind::no_op, "a text without a field op that is a string");
  expect_refused(R"({"op":7})", Kind::no_op, "a text without a field op that is a string");
  expect_refused(R"({"op":"advertiseServices"})", Kind::unknown_op, "op = \"advertiseServices\": no such op");
  expect_refused(R"({"op":")" + std::string(100, 'x') + "\"}", Kind::unknown_op,
                 "op = \"" + std::string(39, 'x') + "...: no such op");
}

TEST(ClientText, EachFieldOfEachOpIsChecked) {
  const std::vector<std::pair<const char*, const char*>> bad = {
      {R"({"op":"subscribe"})", "subscribe: subscriptions is missing"},
      {R"({"op":"subscribe","subscriptions":{}})", "subscribe: subscriptions = an object: must be an array"},
      {R"({"op":"subscribe","subscriptions":[7]})", "subscribe: subscriptions[0] = 7: must be an object"},
      {R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":2},{"id":1}]})",
       "subscribe: subscriptions[1].channelId is missing"},
      {R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":2}]})",
       "subscribe: subscriptions[0].id = -1: must be a whole number from 0 to 4294967295"},
      {R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":2}]})",
       "subscribe: subscriptions[0].id = 4294967296: must be a whole number from 0 to 4294967295"},
      {R"({"op":"subscribe","subscriptions":[{"id":1.5,"channelId":2}]})",
       "subscribe: subscriptions[0].id = 1.5: must be a whole number from 0 to 4294967295"},
      {R"({"op":"unsubscribe","subscriptionIds":["1"]})",
       "unsubscribe: subscriptionIds[0] = \"1\": must be a whole number from 0 to 4294967295"},
      {R"({"op":"advertise","channels":[{"id":1,"topic":7}]})",
       "advertise: channels[0].topic = 7: must be a string"},
      {R"({"op":"advertise","channels":[{"id":1,"topic":"/a","schemaName":"b"}]})",
       "advertise: channels[0].encoding is missing"},
      {R"({"op":"unadvertise","channelIds":null})", "unadvertise: channelIds = null: must be an array"},
      {R"({"op":"getParameters"})", "getParameters: parameterNames is missing"},
      {R"({"op":"getParameters","parameterNames":[],"id":7})", "getParameters: id = 7: must be a string"},
      {R"({"op":"setParameters","parameters":[{"value":1}]})",
       "setParameters: parameters[0].name is missing"},
      {R"({"op":"setParameters","parameters":[{"name":"a","value":{"b":1}}]})",
       "setParameters: parameters[0].value = an object: must be a number, boolean, string or an array of these"},
      {R"({"op":"setParameters","parameters":[{"name":"a","value":1,"type":7}]})",
       "setParameters: parameters[0].type = 7: must be a string"},
      {R"({"op":"subscribeParameterUpdates","parameterNames":[[]]})",
       "subscribeParameterUpdates: parameterNames[0] = an array: must be a string"},
      {R"({"op":"unsubscribeParameterUpdates","parameterNames":"/a"})",
       "unsubscribeParameterUpdates: parameterNames = \"/a\": must be an array"},
      {R"({"op":"fetchAsset","uri":"a"})", "fetchAsset: requestId is missing"},
      {R"({"op":"fetchAsset","requestId":1})", "fetchAsset: uri is missing"},
  };
  for (const auto& [text, message] : bad) expect_refused(text, Kind::bad_field, message);
}

TEST(ClientText, TooMuchIsRefused) {
  expect_refused(std::string(kLongestText + 1, ' '), Kind::too_large,
                 "a text of 1048577 bytes: at most 1048576 are taken");
  const std::string deep(kLongestText / 2, '[');
  expect_refused(deep + std::string(kLongestText / 2, ']'), Kind::too_large,
                 "a text nested deeper than 16 levels");
  expect_refused(deep, Kind::too_large, "a text nested deeper than 16 levels");
  // As many entries as fit.
  std::string wide = R"({"op":"unsubscribe","subscriptionIds":[0)";
  while (wide.size() + 4 < kLongestText) wide += ",0";
  EXPECT_GT(text_op<Unsubscribe>(wide + "]}").subscriptions.size(), 500'000U);
}

TEST(ClientBinary, Publish) {
  const Raw bytes = {0x01, 0x78, 0x56, 0x34, 0x12, 0xAA, 0xBB};
  for (const Subprotocol subprotocol : kBoth) {
    const auto op = binary_op<Publish>(bytes, subprotocol);
    EXPECT_EQ(op.channel, 0x12345678U);
    EXPECT_EQ(Raw(op.payload.begin(), op.payload.end()), (Raw{0xAA, 0xBB}));
    EXPECT_TRUE(binary_op<Publish>({1, 2, 0, 0, 0}, subprotocol).payload.empty());
    expect_refused(Raw{1, 2, 0, 0}, subprotocol, Kind::truncated,
                   "binary opcode 1: 4 bytes end within its fields");
  }
}

TEST(ClientBinary, ServiceRequest) {
  const Raw bytes = {0x02, 10, 0, 0, 0, 12, 0, 0, 0, 3, 0, 0, 0, 'c', 'd', 'r', 9};
  for (const Subprotocol subprotocol : kBoth) {
    const auto op = binary_op<CallService>(bytes, subprotocol);
    EXPECT_EQ(op.service, 10U);
    EXPECT_EQ(op.call, 12U);
    EXPECT_EQ(op.encoding, "cdr");
    EXPECT_EQ(Raw(op.payload.begin(), op.payload.end()), Raw{9});
    for (std::size_t size = 1; size < 16; ++size) {
      expect_refused(Raw(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)), subprotocol,
                     Kind::truncated,
                     "binary opcode 2: " + std::to_string(size) + " bytes end within its fields");
    }
    Raw claims = bytes;
    claims[12] = 0xFF;  // an encoding of 4,278,190,083 bytes
    expect_refused(claims, subprotocol, Kind::truncated, "binary opcode 2: 17 bytes end within its fields");
  }
}

TEST(ClientBinary, PlaybackControlOfTheSdkAlone) {
  // Play at half speed, with a seek to 2^32 ns, request "ab".
  const Raw bytes = {0x03, 0, 0, 0, 0, 0x3F, 1, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 'a', 'b'};
  const auto op = binary_op<PlaybackControl>(bytes, Subprotocol::sdk_v1);
  EXPECT_TRUE(op.is_play);
  EXPECT_EQ(op.speed, 0.5F);
  EXPECT_EQ(op.seek, 4294967296U);
  EXPECT_EQ(op.request, "ab");
  Raw pause = bytes;
  pause[1] = 1;
  pause[6] = 0;
  EXPECT_FALSE(binary_op<PlaybackControl>(pause, Subprotocol::sdk_v1).is_play);
  EXPECT_EQ(binary_op<PlaybackControl>(pause, Subprotocol::sdk_v1).seek, std::nullopt);
  pause[1] = 2;
  expect_refused(pause, Subprotocol::sdk_v1, Kind::bad_field,
                 "playback command 2: must be 0 (play) or 1 (pause)");
  expect_refused(Raw(bytes.begin(), bytes.end() - 1), Subprotocol::sdk_v1, Kind::truncated,
                 "binary opcode 3: 20 bytes end within its fields");
  expect_refused(bytes, Subprotocol::websocket_v1, Kind::unknown_opcode, "binary opcode 3: no such opcode");
}

TEST(ClientBinary, OtherOpcodesAreRefused) {
  for (const Subprotocol subprotocol : kBoth) {
    expect_refused(Raw{}, subprotocol, Kind::truncated, "an empty binary message");
    for (const int opcode : {0, 4, 5, 255}) {
      expect_refused(Raw{static_cast<std::uint8_t>(opcode), 0, 0, 0, 0}, subprotocol, Kind::unknown_opcode,
                     "binary opcode " + std::to_string(opcode) + ": no such opcode");
    }
  }
}

}  // namespace
}  // namespace bw::foxglove
