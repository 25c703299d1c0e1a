#include <algorithm>

#include "runtime/remote/foxglove/server_ops.hpp"

namespace bw::foxglove {
namespace {

template <class Number>
std::uint8_t* put(std::uint8_t* at, Number value) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) *at++ = static_cast<std::uint8_t>(value >> (8 * i));
  return at;
}

template <class Number>
void append(Bytes& bytes, Number value) {
  bytes.resize(bytes.size() + sizeof(Number));
  put(bytes.data() + bytes.size() - sizeof(Number), value);
}

void append(Bytes& bytes, std::string_view text) {
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.insert(bytes.end(), text.begin(), text.end());
}

std::uint64_t nanoseconds(Time time) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(time.nanoseconds, 0));
}

Bytes asset_head(std::uint32_t request, std::uint8_t status, std::string_view error) {
  Bytes bytes = {4};
  append(bytes, request);
  append(bytes, status);
  append(bytes, error);
  return bytes;
}

}  // namespace

std::array<std::uint8_t, 13> message_head(std::uint32_t subscription, Time time) {
  std::array<std::uint8_t, 13> head = {1};
  put(put(head.data() + 1, subscription), nanoseconds(time));
  return head;
}

Bytes time_bytes(Time time) {
  Bytes bytes = {2};
  append(bytes, nanoseconds(time));
  return bytes;
}

Bytes service_response_bytes(std::uint32_t service, std::uint32_t call, std::string_view encoding,
                             std::span<const std::uint8_t> payload) {
  Bytes bytes = {3};
  bytes.reserve(13 + encoding.size() + payload.size());
  append(bytes, service);
  append(bytes, call);
  append(bytes, encoding);
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  return bytes;
}

Bytes asset_bytes(std::uint32_t request, std::span<const std::uint8_t> data) {
  Bytes bytes = asset_head(request, 0, "");
  bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

Bytes asset_error_bytes(std::uint32_t request, std::string_view error) {
  return asset_head(request, 1, error);
}

}  // namespace bw::foxglove
