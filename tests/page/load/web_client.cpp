#include "tests/page/load/web_client.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bw::test {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

struct FrameHead {
  std::uint8_t opcode = 0;
  bool is_last = false;
  std::size_t begin = 0;  ///< of the payload
  std::size_t length = 0;
};

// RFC 6455, section 5.2; a server does not mask.
std::optional<FrameHead> frame_head(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 2) return std::nullopt;
  FrameHead head{.opcode = static_cast<std::uint8_t>(bytes[0] & 0x0f), .is_last = (bytes[0] & 0x80) != 0};
  const std::uint8_t code = bytes[1] & 0x7f;
  const std::size_t more = code == 127 ? 8 : code == 126 ? 2 : 0;
  if (bytes.size() < 2 + more) return std::nullopt;
  head.length = more == 0 ? code : 0;
  for (std::size_t i = 0; i < more; ++i) head.length = head.length << 8 | bytes[2 + i];
  head.begin = 2 + more;
  return head;
}

}  // namespace

WebClient::WebClient(std::uint16_t port, int receive_buffer, const std::string& token)
    : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  if (socket_ < 0) fail("socket");
  if (receive_buffer > 0) {
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  }
  const int on = 1;
  ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    ::close(std::exchange(socket_, -1));
    fail("connect to port " + std::to_string(port));
  }
  const std::string request = "GET /" + (token.empty() ? "" : "?token=" + token) +
                              " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
                              "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                              "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
                              "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n";
  send_all({reinterpret_cast<const std::uint8_t*>(request.data()), request.size()});
}

WebClient::~WebClient() {
  if (socket_ >= 0) ::close(socket_);
}

WebClient::WebClient(WebClient&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      is_open_(other.is_open_),
      waiting_(std::move(other.waiting_)),
      input_(std::move(other.input_)),
      consumed_(other.consumed_),
      message_(std::move(other.message_)),
      is_text_(other.is_text_) {}

WebClient& WebClient::operator=(WebClient&& other) noexcept {
  std::swap(socket_, other.socket_);
  is_open_ = other.is_open_;
  waiting_ = std::move(other.waiting_);
  input_ = std::move(other.input_);
  consumed_ = other.consumed_;
  message_ = std::move(other.message_);
  is_text_ = other.is_text_;
  return *this;
}

void WebClient::end_by_reset() {
  const linger at_once{.l_onoff = 1, .l_linger = 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
}

void WebClient::send_all(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0) fail("send");
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
}

void WebClient::send_frame(std::uint8_t opcode, std::span<const std::uint8_t> text) {
  std::vector<std::uint8_t> frame = {static_cast<std::uint8_t>(0x80 | opcode)};
  if (text.size() < 126) {
    frame.push_back(static_cast<std::uint8_t>(0x80 | text.size()));
  } else {
    frame.insert(frame.end(),
                 {0xfe, static_cast<std::uint8_t>(text.size() >> 8), static_cast<std::uint8_t>(text.size())});
  }
  frame.insert(frame.end(), {0, 0, 0, 0});  // a mask of zeros leaves the text as it is
  frame.insert(frame.end(), text.begin(), text.end());
  send_all(frame);
}

void WebClient::send_text(std::string_view text) {
  if (!is_open_) {
    waiting_.emplace_back(text);
    return;
  }
  send_frame(1, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void WebClient::send_binary(std::span<const std::uint8_t> bytes) { send_frame(2, bytes); }

bool WebClient::receive(std::size_t limit, const OnMessage& on_message) {
  std::array<std::uint8_t, 65536> chunk;
  const ssize_t got = ::recv(socket_, chunk.data(), std::min(limit, chunk.size()), MSG_DONTWAIT);
  if (got == 0) return false;
  if (got < 0) return errno == EAGAIN || errno == EINTR;
  input_.insert(input_.end(), chunk.begin(), chunk.begin() + got);
  if (!is_open_) take_answer();
  if (is_open_) take_messages(on_message);
  return true;
}

void WebClient::take_answer() {
  constexpr std::string_view kEnd = "\r\n\r\n";
  const auto end = std::search(input_.begin(), input_.end(), kEnd.begin(), kEnd.end());
  if (end == input_.end()) return;
  const std::string answer(input_.begin(), end);
  if (!answer.starts_with("HTTP/1.1 101")) throw std::runtime_error("the server answered " + answer);
  input_.erase(input_.begin(), end + kEnd.size());
  is_open_ = true;
  for (const std::string& text : std::exchange(waiting_, {})) send_text(text);
}

void WebClient::take_messages(const OnMessage& on_message) {
  for (;;) {
    const auto rest = std::span<const std::uint8_t>(input_).subspan(consumed_);
    const auto head = frame_head(rest);
    if (!head || rest.size() - head->begin < head->length) break;
    const auto payload = rest.subspan(head->begin, head->length);
    consumed_ += head->begin + head->length;
    if (head->opcode == 9) send_frame(10, payload);
    if (head->opcode > 2) continue;
    if (head->opcode != 0) is_text_ = head->opcode == 1;
    if (head->is_last && message_.empty()) {
      on_message(is_text_, payload);
      continue;
    }
    message_.insert(message_.end(), payload.begin(), payload.end());
    if (!head->is_last) continue;
    on_message(is_text_, message_);
    message_.clear();
  }
  input_.erase(input_.begin(), input_.begin() + static_cast<std::ptrdiff_t>(consumed_));
  consumed_ = 0;
}

std::string subscribe_to(std::span<const std::uint32_t> channels) {
  std::string text = R"({"op":"subscribe","subscriptions":[)";
  for (std::size_t i = 0; i < channels.size(); ++i) {
    text += (i == 0 ? "" : ",") + (R"({"id":)" + std::to_string(i + 1)) + R"(,"channelId":)" +
            std::to_string(channels[i]) + "}";
  }
  return text + "]}";
}

}  // namespace bw::test
