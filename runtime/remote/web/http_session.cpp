#include "runtime/remote/web/http_session.hpp"

#include <algorithm>
#include <utility>

#include <boost/asio/write.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "runtime/remote/web/request_target.hpp"
#include "runtime/remote/web/socket_session.hpp"

namespace bw::web {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace net = boost::asio;

constexpr std::size_t kChunk = 128 << 10;     // of a file at a time [bytes]
constexpr std::size_t kMaxDrained = 1 << 20;  // read from a client that is told why it is refused [bytes]
constexpr double kWriteTime = 30;             // for a page, or the next chunk of a file [s]
constexpr double kDrainTime = 1;              // [s]

std::string to_text(beast::string_view text) { return {text.data(), text.size()}; }

bool offers_upgrade(const Request& request) {
  std::string value(request.get("Upgrade"));
  std::transform(value.begin(), value.end(), value.begin(),
                 [](char c) { return c < 'A' || c > 'Z' ? c : static_cast<char>(c + 32); });
  return value.find("websocket") != std::string::npos;
}

/// What every answer has, unless it says otherwise itself.
constexpr std::pair<std::string_view, std::string_view> kForAll[] = {
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "strict-origin"},  // no query; with no-referrer, browsers post with the Origin `null`
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Content-Security-Policy", "default-src 'none'; frame-ancestors 'none'"},
};

beast::string_view view(std::string_view text) { return {text.data(), text.size()}; }

}  // namespace

HttpSession::HttpSession(Core& core, net::ip::tcp::socket socket)
    : core_(core),
      counted_(std::in_place, core.connections),
      stream_(std::move(socket)),
      buffer_(static_cast<std::size_t>(core.limits.header_bytes + core.limits.body_bytes)) {
  beast::error_code ignored;
  const auto end = stream_.socket().remote_endpoint(ignored);
  address_ = end.address().to_string();
  peer_ = address_ + ':' + std::to_string(end.port());
  core_.waiting.insert(this);
}

HttpSession::~HttpSession() { core_.waiting.erase(this); }

void HttpSession::drop() {
  beast::error_code ignored;
  stream_.socket().close(ignored);
}

void HttpSession::read_request() {
  parser_.emplace();
  parser_->header_limit(static_cast<std::uint32_t>(core_.limits.header_bytes));
  parser_->body_limit(static_cast<std::uint64_t>(core_.limits.body_bytes));
  stream_.expires_after(to_chrono(core_.limits.header_time));
  http::async_read_header(stream_, buffer_, *parser_,
                          beast::bind_front_handler([self = shared_from_this()](Error error, std::size_t) {
                            self->on_header(error);
                          }));
}

bool HttpSession::refuse_malformed(Error error) {
  if (!error) return false;
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    reply(plain_reply(431, "the header is too long"), false);
  } else if (error == http::error::body_limit) {
    reply(plain_reply(413, "the body is too long"), false);
  } else if (error.category() == make_error_code(http::error::bad_method).category() &&
             error != http::error::end_of_stream && error != http::error::partial_message) {
    reply(plain_reply(400, "this is no HTTP request: " + error.message()), false);
  } else if (error == beast::error::timeout) {
    core_.logger.debug("{}: no whole request in time", peer_);
  }
  return true;
}

void HttpSession::on_header(Error error) {
  if (refuse_malformed(error) || upgrades()) return;
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](Error e, std::size_t) { self->on_body(e); });
}

void HttpSession::on_body(Error error) {
  if (refuse_malformed(error)) return;
  reply(core_.router.answer(request()), parser_->get().keep_alive());
}

Request HttpSession::request() const {
  const auto& message = parser_->get();
  Request result{.method = to_text(message.method_string()),
                 .target = to_text(message.target()),
                 .headers = {},
                 .body = message.body(),
                 .address = address_,
                 .now = now_in_seconds()};
  for (const auto& field : message) {
    result.headers.emplace_back(to_text(field.name_string()), to_text(field.value()));
  }
  return result;
}

bool HttpSession::upgrades() {
  const Request asked = request();
  if (!offers_upgrade(asked)) return false;
  const auto refuse = [this](const Reply& why) {
    reply(why, false);
    return true;
  };
  if (!beast::websocket::is_upgrade(parser_->get())) {
    return refuse(
        plain_reply(400, "this is no WebSocket handshake: GET, HTTP/1.1 and Connection: Upgrade make one"));
  }
  const auto length = parser_->content_length();
  if ((length && *length > 0) || parser_->chunked() || buffer_.size() > 0) {
    return refuse(plain_reply(400, "a WebSocket handshake has no body, and waits for its answer"));
  }
  auto admitted = core_.router.admit(asked);
  if (const auto* why = std::get_if<Reply>(&admitted)) return refuse(*why);
  if (core_.sockets >= core_.limits.sockets) {
    return refuse(plain_reply(503, "too many sockets are open"));
  }
  auto& admission = std::get<Admission>(admitted);
  std::make_shared<SocketSession>(core_, std::move(stream_), std::move(*counted_),
                                  Opening{.subprotocol = std::move(admission.subprotocol),
                                          .peer = peer_,
                                          .origin = std::move(admission.origin),
                                          .read_only = std::move(admission.read_only)})
      ->accept(parser_->release());
  return true;
}

void HttpSession::reply(Reply reply, bool keep_open) {
  reply_ = std::move(reply);
  keeps_open_ = keep_open && !core_.is_stopping;
  is_head_only_ = parser_->is_header_done() && parser_->get().method() == http::verb::head;
  if (reply_.status >= 400) {
    const auto* reason = std::get_if<std::string>(&reply_.body);
    core_.logger.debug("{}: {} {}: {} {}", peer_, to_text(parser_->get().method_string()).substr(0, 20),
                       printable_path(to_text(parser_->get().target())), reply_.status,
                       reason ? std::string_view(*reason).substr(0, reason->find('\n')) : "");
  }
  head_ = {};
  head_.version(11);
  head_.result(static_cast<unsigned>(reply_.status));
  head_.keep_alive(keeps_open_);
  for (const auto& [name, value] : kForAll) head_.set(view(name), view(value));
  for (const auto& [name, value] : reply_.headers) head_.set(name, value);
  if (reply_.status != 304 && reply_.status != 204) head_.content_length(reply_.size());
  serializer_.emplace(head_);
  stream_.expires_after(to_chrono(kWriteTime));
  http::async_write_header(stream_, *serializer_, [self = shared_from_this()](Error error, std::size_t) {
    if (error) return;
    if (self->is_head_only_ || self->reply_.size() == 0) return self->on_replied({});
    self->write_body();
  });
}

void HttpSession::write_body() {
  if (std::holds_alternative<FilePart>(reply_.body)) {
    chunk_.resize(kChunk);
    write_file_part();
    return;
  }
  const auto* text = std::get_if<std::string>(&reply_.body);
  const auto bytes = text ? std::span(reinterpret_cast<const std::uint8_t*>(text->data()), text->size())
                          : std::get<std::span<const std::uint8_t>>(reply_.body);
  net::async_write(stream_, net::buffer(bytes.data(), bytes.size()),
                   [self = shared_from_this()](Error error, std::size_t) { self->on_replied(error); });
}

void HttpSession::write_file_part() {
  auto& part = std::get<FilePart>(reply_.body);
  if (part.begin == part.end) {
    chunk_ = {};
    on_replied({});
    return;
  }
  const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(kChunk, part.end - part.begin));
  const std::size_t size = part.file->read(part.begin, chunk_.data(), most);
  if (size == 0) {  // cut since it was opened: what was promised cannot be kept
    drop();
    return;
  }
  part.begin += size;
  stream_.expires_after(to_chrono(kWriteTime));
  net::async_write(stream_, net::buffer(chunk_.data(), size),
                   [self = shared_from_this()](Error error, std::size_t) {
                     if (!error) self->write_file_part();
                   });
}

void HttpSession::on_replied(Error error) {
  if (error) return;
  reply_ = {};
  if (keeps_open_) {
    read_request();
    return;
  }
  Error ignored;
  stream_.socket().shutdown(net::ip::tcp::socket::shutdown_send, ignored);
  stream_.expires_after(to_chrono(kDrainTime));
  drain();
}

// Who is still sending would lose the answer if the connection were closed under it.
void HttpSession::drain() {
  chunk_.resize(4096);
  stream_.async_read_some(net::buffer(chunk_), [self = shared_from_this()](Error error, std::size_t size) {
    self->drained_ += size;
    if (!error && self->drained_ < kMaxDrained) self->drain();
  });
}

}  // namespace bw::web
