// What clients send, decoded without trust: no exception leaves, nothing is allocated for a length that is
// only claimed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/parameters/parameter_set.hpp"
#include "runtime/remote/foxglove/protocol.hpp"

namespace bw::foxglove {

/// Longer texts are refused before they are looked at [bytes]: clients publish and call in binary messages.
inline constexpr std::size_t kLongestText = std::size_t{1} << 20;
/// Arrays and objects within each other.
inline constexpr std::size_t kDeepestText = 16;

struct Subscription {
  std::uint32_t id = 0;  ///< the client's choice
  std::uint32_t channel = 0;
};
struct Subscribe {
  std::vector<Subscription> subscriptions;
};
struct Unsubscribe {
  std::vector<std::uint32_t> subscriptions;
};

/// A channel on which a client publishes; a schema that it gives is not needed and not kept.
struct ClientChannel {
  std::uint32_t id = 0;  ///< the client's choice
  std::string topic;
  std::string encoding;
  std::string schema_name;  ///< geometry_msgs/PoseStamped or geometry_msgs/msg/PoseStamped
};
struct Advertise {
  std::vector<ClientChannel> channels;
};
struct Unadvertise {
  std::vector<std::uint32_t> channels;
};

/// No names: all.
struct GetParameters {
  std::vector<std::string> names;
  std::optional<std::string> request;
};
/// A value that is not set asks to delete the parameter.
struct SetParameters {
  std::vector<NamedValue> parameters;
  std::optional<std::string> request;
};
struct SubscribeParameterUpdates {
  std::vector<std::string> names;
};
struct UnsubscribeParameterUpdates {
  std::vector<std::string> names;
};

struct SubscribeConnectionGraph {};
struct UnsubscribeConnectionGraph {};

struct FetchAsset {
  std::string uri;
  std::uint32_t request = 0;
};

using TextOp = std::variant<Subscribe, Unsubscribe, Advertise, Unadvertise, GetParameters, SetParameters,
                            SubscribeParameterUpdates, UnsubscribeParameterUpdates, SubscribeConnectionGraph,
                            UnsubscribeConnectionGraph, FetchAsset>;

std::variant<TextOp, ProtocolError> decode_text(std::string_view text);

/// Opcode 1: u32 channel, payload.
struct Publish {
  std::uint32_t channel = 0;
  std::span<const std::uint8_t> payload;
};
/// Opcode 2: u32 service, u32 call, u32 length, encoding, payload.
struct CallService {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
  std::string_view encoding;
  std::span<const std::uint8_t> payload;
};
/// Opcode 3 of foxglove.sdk.v1: u8 command (0 play, 1 pause), f32 speed, u8 had seek, u64 seek [ns], u32
/// length, request.
struct PlaybackControl {
  bool is_play = false;
  float speed = 0.0F;
  std::optional<std::uint64_t> seek;
  std::string_view request;
};
using BinaryOp = std::variant<Publish, CallService, PlaybackControl>;

/// What it gives are views of `bytes`. All numbers are little-endian.
std::variant<BinaryOp, ProtocolError> decode_binary(std::span<const std::uint8_t> bytes,
                                                    Subprotocol subprotocol);

}  // namespace bw::foxglove
