#include "tests/runtime/remote/web/raw_client.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bw::test {
namespace {

constexpr char kMask[] = {0x12, 0x34, 0x56, 0x78};

std::string small(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

int SocketFrame::close_code() const {
  if (opcode != 8 || payload.size() < 2) return 0;
  return static_cast<std::uint8_t>(payload[0]) << 8 | static_cast<std::uint8_t>(payload[1]);
}

RawClient::RawClient(std::uint16_t port) : RawClient(port, 0) {}
RawClient RawClient::that_reads_little(std::uint16_t port) { return {port, 1}; }

RawClient::RawClient(std::uint16_t port, int receive_buffer) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  if (receive_buffer > 0) setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof(receive_buffer));
  const timeval limit{.tv_sec = 30, .tv_usec = 0};
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof(limit));
  setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof(limit));
  sockaddr_in end{};
  end.sin_family = AF_INET;
  end.sin_port = htons(port);
  end.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&end), sizeof(end)), 0) << "port " << port;
}

RawClient::RawClient(RawClient&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), read_(std::move(other.read_)) {}

RawClient::~RawClient() {
  if (socket_ >= 0) close(socket_);
}

void RawClient::end_sending() { shutdown(socket_, SHUT_WR); }

void RawClient::reset() {
  const linger now{.l_onoff = 1, .l_linger = 0};
  setsockopt(socket_, SOL_SOCKET, SO_LINGER, &now, sizeof(now));
  close(std::exchange(socket_, -1));
}

bool RawClient::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t size = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (size <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(size));
  }
  return true;
}

bool RawClient::fill() {
  char part[65536];
  const ssize_t size = recv(socket_, part, sizeof(part), 0);
  if (size <= 0) return false;
  read_.append(part, static_cast<std::size_t>(size));
  return true;
}

HttpResponse RawClient::receive(bool has_body) {
  std::size_t end = 0;
  while ((end = read_.find("\r\n\r\n")) == std::string::npos) {
    if (!fill()) return {};
  }
  HttpResponse response;
  response.status = std::atoi(read_.substr(9, 3).c_str());
  std::size_t line = read_.find("\r\n") + 2;
  while (line < end + 2) {
    const std::size_t next = read_.find("\r\n", line);
    const std::size_t colon = read_.find(": ", line);
    response.headers[small(read_.substr(line, colon - line))] = read_.substr(colon + 2, next - colon - 2);
    line = next + 2;
  }
  read_.erase(0, end + 4);
  const auto length = response.headers.find("content-length");
  if (!has_body || length == response.headers.end()) return response;
  const auto size = static_cast<std::size_t>(std::stoull(length->second));
  while (read_.size() < size && fill()) continue;
  response.body = read_.substr(0, size);
  read_.erase(0, size);
  return response;
}

SocketFrame RawClient::receive_frame() {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(read_[i]); };
  const auto has = [&](std::size_t size) {
    while (read_.size() < size) {
      if (!fill()) return false;
    }
    return true;
  };
  if (!has(2)) return {};
  std::size_t head = 2;
  std::size_t size = byte(1) & 127U;
  if (size >= 126) {
    const std::size_t digits = size == 126 ? 2 : 8;
    if (!has(head + digits)) return {};
    size = 0;
    for (std::size_t i = 0; i < digits; ++i) size = size << 8 | byte(head + i);
    head += digits;
  }
  if (!has(head + size)) return {};
  SocketFrame frame{byte(0) & 15, (byte(0) & 128U) != 0, read_.substr(head, size)};
  read_.erase(0, head + size);
  return frame;
}

bool RawClient::ends() {
  while (true) {
    char part[65536];
    const ssize_t size = recv(socket_, part, sizeof(part), 0);
    if (size == 0) return true;
    if (size < 0) return errno != EAGAIN && errno != EWOULDBLOCK;
  }
}

std::string request_text(std::string_view method, std::string_view target, std::string_view more,
                         std::string_view body) {
  std::string text(method);
  text.append(" ").append(target).append(" HTTP/1.1\r\nHost: 127.0.0.1\r\n").append(more);
  if (!body.empty()) text.append("Content-Length: ").append(std::to_string(body.size())).append("\r\n");
  return text.append("\r\n").append(body);
}

HttpResponse ask(std::uint16_t port, std::string_view method, std::string_view target, std::string_view more,
                 std::string_view body) {
  RawClient client(port);
  client.send(request_text(method, target, more, body));
  return client.receive(method != "HEAD");
}

std::string handshake_text(std::string_view more, std::string_view protocols, std::string_view target) {
  std::string headers =
      "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: "
      "dGhlIHNhbXBsZSBub25jZQ==\r\n";
  if (!protocols.empty()) headers.append("Sec-WebSocket-Protocol: ").append(protocols).append("\r\n");
  return request_text("GET", target, headers.append(more));
}

RawClient open_socket(std::uint16_t port) {
  RawClient client(port);
  client.send(handshake_text());
  EXPECT_EQ(client.receive().status, 101);
  return client;
}

std::string frame_text(std::uint8_t first_byte, std::string_view payload) {
  std::string text(1, static_cast<char>(first_byte));
  const std::size_t size = payload.size();
  const int digits = size < 126 ? 0 : size < 65536 ? 2 : 8;
  text += static_cast<char>(0x80U | (digits == 0 ? size : digits == 2 ? 126U : 127U));
  for (int i = digits - 1; i >= 0; --i) text += static_cast<char>(size >> (8 * i));
  text.append(kMask, sizeof(kMask));
  for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(payload[i] ^ kMask[i % 4]);
  return text;
}

}  // namespace bw::test
