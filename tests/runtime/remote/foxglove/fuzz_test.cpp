// Whatever a client sends, the server stays: it neither throws nor crashes, allocates out of proportion, or
// keeps what the client left.
// BANDWAGON_FOXGLOVE_FUZZ: how many messages, instead of the few of an ordinary run.
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "tests/runtime/largest_allocation.hpp"
#include "tests/runtime/remote/foxglove/rig.hpp"

namespace bw::foxglove::test {
namespace {

long mutations() {
  const char* asked = std::getenv("BANDWAGON_FOXGLOVE_FUZZ");
  return asked == nullptr ? 200'000 : std::atol(asked);
}

const std::vector<std::string> kTexts = {
    R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":1},{"id":1,"channelId":2}]})",
    R"({"op":"unsubscribe","subscriptionIds":[0,1]})",
    R"({"op":"advertise","channels":[{"id":1,"topic":"/goal_pose","encoding":"json","schemaName":"geometry_msgs/PoseStamped"}]})",
    R"({"op":"unadvertise","channelIds":[1]})",
    R"({"op":"getParameters","parameterNames":["/a.b"],"id":"r"})",
    R"({"op":"setParameters","parameters":[{"name":"/a.b","value":[1,2.5]},{"name":"c","value":"QUJDRA==","type":"byte_array"}],"id":"s"})",
    R"({"op":"subscribeParameterUpdates","parameterNames":[]})",
    R"({"op":"unsubscribeParameterUpdates","parameterNames":["/a.b"]})",
    R"({"op":"subscribeConnectionGraph"})",
    R"({"op":"unsubscribeConnectionGraph"})",
    R"({"op":"fetchAsset","uri":"package://foo/robot.urdf","requestId":123})",
};

std::vector<std::string> binaries() {
  return {Packed().le(std::uint8_t{1}).le(1U).text("{}"),
          Packed().le(std::uint8_t{2}).le(5U).le(7U).le(4U).text("json").text("{}"),
          Packed()
              .le(std::uint8_t{3})
              .le(std::uint8_t{0})
              .le(0x3F800000U)
              .le(std::uint8_t{1})
              .le(std::uint64_t{1})
              .le(2U)
              .text("ab")};
}

class Fuzz : public Rig {
 protected:
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(random_() % end); }

  /// Numbers, brackets and stretches of other messages do more than bytes alone.
  std::string mutated(std::string bytes, const std::vector<std::string>& others) {
    static const std::vector<std::string> kPieces = {"-1",
                                                     "4294967296",
                                                     "1e999",
                                                     "null",
                                                     "[",
                                                     "{",
                                                     "]",
                                                     "}",
                                                     "\"",
                                                     ",",
                                                     ":",
                                                     "\\u0000",
                                                     "\\ud800",
                                                     "true",
                                                     "0.5",
                                                     "\xff",
                                                     std::string("\xff\xff\xff\xff", 4),
                                                     std::string("\0\0\0\x80", 4),
                                                     std::string(50, '['),
                                                     "\"id\":"};
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
      const std::size_t at = below(bytes.size() + 1);
      const std::size_t count = below(bytes.size() - at + 1);
      switch (below(6)) {
        case 0:
          if (at < bytes.size()) bytes[at] = static_cast<char>(random_());
          break;
        case 1:
          bytes.erase(at, count);
          break;
        case 2:
          bytes.insert(at, kPieces[below(kPieces.size())]);
          break;
        case 3:
          bytes.replace(at, std::min<std::size_t>(count, 8), kPieces[below(kPieces.size())]);
          break;
        case 4:
          bytes.insert(at, bytes.substr(at, count));
          break;
        default: {
          const std::string& other = others[below(others.size())];
          bytes.replace(at, count, other.substr(below(other.size())));
        }
      }
      if (bytes.size() > 4096) bytes.resize(4096);
    }
    return bytes;
  }

  /// The robot answers some of what was asked, and forgets the rest at the end.
  void answer() {
    for (const FakeRobot::Call& made : robot_.calls) made.answer(Bytes{1});
    for (const FakeRobot::ParameterRequest& made : robot_.gets) made.values({{"/a.b", 1.0}}, {"c"});
    for (const FakeRobot::ParameterRequest& made : robot_.sets) made.values(made.parameters, {});
    robot_.calls.clear();
    robot_.gets.clear();
    robot_.sets.clear();
    robot_.published.clear();
  }

  std::mt19937_64 random_{7};
};

TEST_F(Fuzz, MutatedMessagesOfEveryKind) {
  server_->on_channels({channel(1, "/a"), channel(2, "/map", true)}, {});
  server_->on_services({service(5, "/arm")}, {});
  robot_.last[2] = {{Time::seconds(1), bytes_of("map")}};
  const std::vector<std::string> raw = binaries();
  const long count = mutations();
  largest_allocation = 0;
  ConnectionId client = 0;
  for (long i = 0; i < count; ++i) {
    if (i % 100 == 0) {
      if (client != 0) server_->on_close(client);
      sender_.take(client);
      answer();
      ++client;
      open(client, client % 4 != 0, kSubprotocols[client % 2]);
    }
    if (below(2) == 0) {
      server_->on_text(client, mutated(kTexts[below(kTexts.size())], kTexts));
    } else {
      binary(client, mutated(raw[below(raw.size())], raw));
    }
    if (below(8) == 0) {
      server_->on_time(Time::seconds(static_cast<double>(below(1000))));
      server_->on_message(1 + static_cast<std::uint32_t>(below(2)), Time::seconds(1), bytes_of("x"));
      answer();
    }
  }
  server_->on_close(client);
  // A message is 4 kB at most; what is kept of it, and the list of what the client was sent, are of that
  // order.
  EXPECT_LT(largest_allocation, std::size_t{1} << 20);
  for (const auto& [channel, subscribers] : robot_.subscribers) EXPECT_EQ(subscribers, 0);
  EXPECT_TRUE(robot_.advertised.empty());
  std::printf("%ld mutated messages, largest allocation %zu bytes\n", count, largest_allocation);
}

}  // namespace
}  // namespace bw::foxglove::test
