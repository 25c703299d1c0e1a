// One HTTP connection: request after request, until it ends or becomes a WebSocket.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/string_body.hpp>

#include "runtime/remote/web/core.hpp"

namespace bw::web {

class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(Core& core, boost::asio::ip::tcp::socket socket);
  ~HttpSession();
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  void read_request();
  void drop();

 private:
  using Error = boost::beast::error_code;
  void on_header(Error error);
  void on_body(Error error);
  /// True where the connection is another's now, or is being answered.
  bool upgrades();
  bool refuse_malformed(Error error);
  Request request() const;
  void reply(Reply reply, bool keep_open);
  void write_body();
  void write_file_part();
  void on_replied(Error error);
  void drain();

  Core& core_;
  std::optional<Counted> counted_;
  boost::beast::tcp_stream stream_;
  std::string peer_;     ///< address:port
  std::string address_;  ///< without the port
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;

  Reply reply_;
  boost::beast::http::response<boost::beast::http::empty_body> head_;
  std::optional<boost::beast::http::response_serializer<boost::beast::http::empty_body>> serializer_;
  bool is_head_only_ = false;
  bool keeps_open_ = false;
  std::vector<char> chunk_;
  std::size_t drained_ = 0;
};

}  // namespace bw::web
