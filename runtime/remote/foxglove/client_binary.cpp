#include <bit>

#include <fmt/format.h>

#include "runtime/remote/foxglove/client_ops.hpp"

namespace bw::foxglove {
namespace {

using Kind = ProtocolError::Kind;

/// Takes numbers and stretches from the front; after the first that is not there everything is empty.
class Front {
 public:
  explicit Front(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <class Number>
  Number number() {
    Number value = 0;
    const std::span<const std::uint8_t> taken = take(sizeof(Number));
    for (std::size_t i = taken.size(); i-- > 0;) value = static_cast<Number>((value << 8) | taken[i]);
    return value;
  }

  /// As long as a u32 before it says.
  std::string_view text() {
    const std::span<const std::uint8_t> taken = take(number<std::uint32_t>());
    return {reinterpret_cast<const char*>(taken.data()), taken.size()};
  }

  std::span<const std::uint8_t> rest() { return take(bytes_.size()); }
  bool is_truncated() const { return is_truncated_; }

 private:
  std::span<const std::uint8_t> take(std::size_t count) {
    if (is_truncated_ || count > bytes_.size()) {
      is_truncated_ = true;
      return {};
    }
    const std::span<const std::uint8_t> taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }

  std::span<const std::uint8_t> bytes_;
  bool is_truncated_ = false;
};

Publish read_publish(Front& front) {
  Publish op;
  op.channel = front.number<std::uint32_t>();
  op.payload = front.rest();
  return op;
}

CallService read_call(Front& front) {
  CallService op;
  op.service = front.number<std::uint32_t>();
  op.call = front.number<std::uint32_t>();
  op.encoding = front.text();
  op.payload = front.rest();
  return op;
}

std::variant<BinaryOp, ProtocolError> read_playback(Front& front) {
  PlaybackControl op;
  const auto command = front.number<std::uint8_t>();
  op.is_play = command == 0;
  op.speed = std::bit_cast<float>(front.number<std::uint32_t>());
  const bool had_seek = front.number<std::uint8_t>() != 0;
  const auto seek = front.number<std::uint64_t>();
  if (had_seek) op.seek = seek;
  op.request = front.text();
  if (command > 1)
    return ProtocolError{Kind::bad_field,
                         fmt::format("playback command {}: must be 0 (play) or 1 (pause)", command)};
  return BinaryOp{op};
}

}  // namespace

std::variant<BinaryOp, ProtocolError> decode_binary(std::span<const std::uint8_t> bytes,
                                                    Subprotocol subprotocol) {
  if (bytes.empty()) return ProtocolError{Kind::truncated, "an empty binary message"};
  const std::uint8_t opcode = bytes.front();
  Front front(bytes.subspan(1));
  std::variant<BinaryOp, ProtocolError> op =
      ProtocolError{Kind::unknown_opcode, fmt::format("binary opcode {}: no such opcode", opcode)};
  if (opcode == 1) op = BinaryOp{read_publish(front)};
  if (opcode == 2) op = BinaryOp{read_call(front)};
  if (opcode == 3 && subprotocol == Subprotocol::sdk_v1) op = read_playback(front);
  if (front.is_truncated())
    return ProtocolError{Kind::truncated, fmt::format("binary opcode {}: {} bytes end within its fields",
                                                      opcode, bytes.size())};
  return op;
}

}  // namespace bw::foxglove
