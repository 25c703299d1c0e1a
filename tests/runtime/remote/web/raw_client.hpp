// A client of HTTP and WebSocket on plain sockets: says what no library would, and reads answers by itself.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace bw::test {

struct HttpResponse {
  int status = 0;                              ///< 0: the connection ended before a header was there
  std::map<std::string, std::string> headers;  ///< names in small letters
  std::string body;
};

struct SocketFrame {
  int opcode = -1;  ///< -1: the connection ended
  bool is_last = true;
  std::string payload;

  /// Of a close frame; 0 where it has none.
  int close_code() const;
};

class RawClient {
 public:
  explicit RawClient(std::uint16_t port);
  ~RawClient();
  RawClient(RawClient&& other) noexcept;
  RawClient& operator=(RawClient&&) = delete;

  /// False: the server has closed.
  bool send(std::string_view bytes);
  /// One answer; `has_body` false after HEAD. Waits for at most 30 s.
  HttpResponse receive(bool has_body = true);
  SocketFrame receive_frame();
  /// Reads to the end: true when the server closes within 30 s.
  bool ends();
  /// What has come may not be read: the kernel's buffer is as small as it can be from the start.
  static RawClient that_reads_little(std::uint16_t port);
  /// What was sent is all; answers still come.
  void end_sending();
  /// Closes so that the port is free at once (RST).
  void reset();

 private:
  RawClient(std::uint16_t port, int receive_buffer);
  bool fill();  ///< more bytes; false at the end

  int socket_ = -1;
  std::string read_;
};

/// `METHOD TARGET HTTP/1.1` with Host 127.0.0.1 and more header lines, each with its \r\n.
std::string request_text(std::string_view method, std::string_view target, std::string_view more = {},
                         std::string_view body = {});
HttpResponse ask(std::uint16_t port, std::string_view method, std::string_view target,
                 std::string_view more = {}, std::string_view body = {});

/// A handshake as a browser makes it.
std::string handshake_text(std::string_view more = {}, std::string_view protocols = "foxglove.websocket.v1",
                           std::string_view target = "/");
/// An open socket; the test fails where there is none.
RawClient open_socket(std::uint16_t port);

/// As a client has to send it, masked. `first_byte` is FIN, RSV and opcode: 0x81 text, 0x82 binary.
std::string frame_text(std::uint8_t first_byte, std::string_view payload);

}  // namespace bw::test
