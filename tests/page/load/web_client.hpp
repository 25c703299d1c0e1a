// A WebSocket client on a plain socket, for loads: it takes frames apart and decodes nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bw::test {

/// Every failure is a std::runtime_error with what the system says.
class WebClient {
 public:
  /// Connects to 127.0.0.1 and asks for the protocol; the answer is not waited for. `receive_buffer` is the
  /// socket's, 0 the system's own. `token`: what commands need; empty: it reads.
  explicit WebClient(std::uint16_t port, int receive_buffer = 0, const std::string& token = "");
  ~WebClient();
  WebClient(WebClient&& other) noexcept;
  WebClient& operator=(WebClient&& other) noexcept;

  int descriptor() const { return socket_; }
  bool is_open() const { return is_open_; }
  /// As soon as the server has answered, which receive() sees.
  void send_text(std::string_view text);
  void send_binary(std::span<const std::uint8_t> bytes);
  /// The next close sends a reset instead of an orderly end.
  void end_by_reset();

  using OnMessage = std::function<void(bool is_text, std::span<const std::uint8_t> payload)>;
  /// Takes what has come, at most `limit` bytes; false: the server has closed.
  bool receive(std::size_t limit, const OnMessage& on_message);

 private:
  void send_frame(std::uint8_t opcode, std::span<const std::uint8_t> text);
  void take_answer();
  void take_messages(const OnMessage& on_message);
  void send_all(std::span<const std::uint8_t> bytes);

  int socket_ = -1;
  bool is_open_ = false;              // the answer to the upgrade was taken
  std::vector<std::string> waiting_;  // to be sent then
  std::vector<std::uint8_t> input_;   // of which the first consumed_ bytes are done
  std::size_t consumed_ = 0;
  std::vector<std::uint8_t> message_;  // in fragments so far
  bool is_text_ = false;
};

/// The messages that subscribe, ids counted from 1 in the order of the channels.
std::string subscribe_to(std::span<const std::uint32_t> channels);

}  // namespace bw::test
