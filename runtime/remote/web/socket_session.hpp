// One WebSocket: its queue, its writes one after the other, its reads, its end.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "runtime/remote/web/core.hpp"
#include "runtime/remote/web/send_queue.hpp"

namespace bw::web {

class SocketSession : public std::enable_shared_from_this<SocketSession> {
 public:
  SocketSession(Core& core, boost::beast::tcp_stream stream, Counted counted, Opening opening);

  void accept(boost::beast::http::request<boost::beast::http::string_body> request);
  /// From any thread.
  void send(Frame frame, Keep keep);
  /// From any thread. At once: without what is queued.
  void close(std::uint16_t code, const std::string& reason, bool at_once = false);
  /// Now and then: pings who is silent, drops who is gone.
  void look_after(double now);
  void drop();
  /// When the server has stopped: the handler hears that it is gone.
  void finish();

 private:
  using Error = boost::beast::error_code;
  using Stream = boost::beast::websocket::stream<boost::beast::tcp_stream, false>;
  void on_accepted(Error error);
  void read();
  void on_read(Error error);
  void deliver();
  void pump();
  void on_written(Error error);
  void write_close();

  Core& core_;
  const Counted counted_;
  const Counted counted_socket_;
  const ConnectionId id_;
  const Opening opening_;
  Stream stream_;
  boost::beast::http::request<boost::beast::http::string_body> request_;
  boost::beast::flat_buffer buffer_;
  Frame in_flight_;
  std::optional<double> writing_since_;
  double heard_ = 0;
  bool is_pinging_ = false;
  bool is_open_ = false;  ///< the handler knows it

  std::mutex mutex_;  // for what follows
  SendQueue queue_;
  bool is_pumping_ = false;
  std::optional<boost::beast::websocket::close_reason> closing_;
  std::optional<double> closing_since_;
};

}  // namespace bw::web
