// What both sides of Foxglove's WebSocket protocol agree on. Source: the public text of
// `foxglove.websocket.v1` (foxglove/ws-protocol at 5efa728) and the documented layouts of
// `foxglove.sdk.v1`, which has the same JSON ops and binary opcodes, and playback control besides.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace bw::foxglove {

/// The names that a client offers and of which the server echoes one, the preferred one first.
inline constexpr std::string_view kSdkV1 = "foxglove.sdk.v1";
inline constexpr std::string_view kWebsocketV1 = "foxglove.websocket.v1";
inline constexpr std::array<std::string_view, 2> kSubprotocols = {kSdkV1, kWebsocketV1};

enum class Subprotocol : std::uint8_t { websocket_v1, sdk_v1 };

/// Encodings that clients publish and call services in.
inline constexpr std::string_view kCdr = "cdr";
inline constexpr std::string_view kJson = "json";

/// Of a status: how bad it is.
enum class Level : std::uint8_t { info = 0, warning = 1, error = 2 };

/// Why something that a client sent is no message of the protocol.
struct ProtocolError {
  enum class Kind : std::uint8_t {
    too_large,       ///< longer or deeper than any honest message
    not_json,        ///< a text that is no JSON
    no_op,           ///< JSON without a field op that is a string
    unknown_op,      ///< an op that no client sends
    bad_field,       ///< a field is missing, or has another type or range
    unknown_opcode,  ///< the first byte of a binary message
    truncated,       ///< a binary message ends within its fields, or says a length beyond its end
  };
  Kind kind = Kind::not_json;
  std::string message;  ///< one sentence with op, field, value and rule
};

}  // namespace bw::foxglove
