#include "runtime/remote/web/socket_session.hpp"

#include <array>
#include <exception>
#include <utility>

#include <boost/asio/dispatch.hpp>
#include <boost/asio/post.hpp>

namespace bw::web {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace net = boost::asio;
namespace websocket = beast::websocket;

constexpr int kKernelBuffer = 256 << 10;  // so that a slow client's data wait where older ones can go [bytes]
constexpr std::size_t kReadAtOnce = 64 << 10;   // [bytes]
constexpr std::size_t kKeptBuffer = 256 << 10;  // of a message that was read [bytes]

QueueLimits queue_limits(const Limits& limits) {
  return {.data_bytes = static_cast<std::size_t>(limits.queued_bytes),
          .data_frames = static_cast<std::size_t>(limits.queued_frames),
          .control_bytes = static_cast<std::size_t>(limits.control_bytes),
          .control_frames = static_cast<std::size_t>(limits.control_frames)};
}

}  // namespace

SocketSession::SocketSession(Core& core, beast::tcp_stream stream, Counted counted, Opening opening)
    : core_(core),
      counted_(std::move(counted)),
      counted_socket_(core.sockets),
      id_(++core.last_id),
      opening_(std::move(opening)),
      stream_(std::move(stream)),
      buffer_(static_cast<std::size_t>(core.limits.message_bytes) + kReadAtOnce),
      heard_(now_in_seconds()),
      queue_(queue_limits(core.limits)) {
  Error ignored;
  auto& tcp = beast::get_lowest_layer(stream_);
  tcp.expires_never();
  tcp.socket().set_option(net::socket_base::send_buffer_size(kKernelBuffer), ignored);
  stream_.read_message_max(static_cast<std::size_t>(core.limits.message_bytes));
  stream_.auto_fragment(false);  // a message is one frame, and its bytes are written from where they are
  stream_.set_option(websocket::stream_base::timeout{to_chrono(core.limits.close_time),
                                                     websocket::stream_base::none(), false});
  stream_.set_option(websocket::stream_base::decorator(
      [protocol = opening_.subprotocol](websocket::response_type& response) {
        response.set(http::field::sec_websocket_protocol, protocol);
      }));
  stream_.control_callback([this](websocket::frame_type, beast::string_view) { heard_ = now_in_seconds(); });
}

void SocketSession::accept(http::request<http::string_body> request) {
  request_ = std::move(request);
  stream_.async_accept(request_, [self = shared_from_this()](Error error) { self->on_accepted(error); });
}

void SocketSession::on_accepted(Error error) {
  request_ = {};
  if (error || core_.is_stopping) {
    core_.logger.debug("{}: no WebSocket: {}", opening_.peer, error.message());
    drop();
    return;
  }
  heard_ = now_in_seconds();
  core_.add(id_, shared_from_this());
  is_open_ = true;
  core_.logger.debug("{}: socket {} open, {}", opening_.peer, id_, opening_.subprotocol);
  read();
  core_.handler->on_open(id_, opening_);
}

void SocketSession::read() {
  stream_.async_read_some(buffer_, kReadAtOnce,
                          [self = shared_from_this()](Error error, std::size_t) { self->on_read(error); });
}

void SocketSession::on_read(Error error) {
  if (error) {
    if (error != websocket::error::closed)
      core_.logger.debug("{}: socket {}: {}", opening_.peer, id_, error.message());
    drop();
    finish();
    return;
  }
  heard_ = now_in_seconds();
  if (stream_.is_message_done()) {
    deliver();
    buffer_.consume(buffer_.size());
    if (buffer_.capacity() > kKeptBuffer) buffer_.shrink_to_fit();
  }
  read();
}

void SocketSession::deliver() {
  {
    const std::lock_guard lock(mutex_);
    if (closing_) return;
  }
  const auto data = buffer_.cdata();
  try {
    if (stream_.got_text()) {
      core_.handler->on_text(id_, {static_cast<const char*>(data.data()), data.size()});
    } else {
      core_.handler->on_binary(id_, {static_cast<const std::uint8_t*>(data.data()), data.size()});
    }
  } catch (const std::exception& error) {
    core_.logger.error("{}: socket {}: {}", opening_.peer, id_, error.what());
    close(websocket::close_code::internal_error, "this message could not be dealt with", true);
  }
}

void SocketSession::send(Frame frame, Keep keep) {
  bool starts = false;
  bool fits = true;
  {
    const std::lock_guard lock(mutex_);
    if (closing_) return;
    fits = queue_.push(std::move(frame), keep);
    if (fits) starts = !std::exchange(is_pumping_, true);
  }
  if (!fits) {
    close(websocket::close_code::policy_error, "answers were not read in time", true);
  } else if (starts) {
    net::dispatch(core_.io, [self = shared_from_this()] { self->pump(); });
  }
}

void SocketSession::close(std::uint16_t code, const std::string& reason, bool at_once) {
  bool starts = false;
  {
    const std::lock_guard lock(mutex_);
    if (closing_) return;
    closing_.emplace(static_cast<websocket::close_code>(code), beast::string_view(reason).substr(0, 123));
    closing_since_ = now_in_seconds();
    if (at_once) queue_.clear();
    starts = !std::exchange(is_pumping_, true);
  }
  if (starts) net::post(core_.io, [self = shared_from_this()] { self->pump(); });
}

void SocketSession::pump() {
  {
    const std::lock_guard lock(mutex_);
    auto next = queue_.pop();
    if (!next) {
      if (closing_) return write_close();  // is_pumping_ stays: nothing is written after it
      is_pumping_ = false;
      return;
    }
    in_flight_ = std::move(*next);
  }
  writing_since_ = now_in_seconds();
  stream_.text(in_flight_.is_text);
  const auto head = in_flight_.head.bytes();
  const Bytes* body = in_flight_.body.get();
  const std::array<net::const_buffer, 2> buffers = {net::buffer(head.data(), head.size()),
                                                    body ? net::buffer(*body) : net::const_buffer()};
  stream_.async_write(buffers,
                      [self = shared_from_this()](Error error, std::size_t) { self->on_written(error); });
}

void SocketSession::on_written(Error error) {
  in_flight_ = {};
  writing_since_.reset();
  if (error) return drop();  // the read that is waiting ends by it
  pump();
}

void SocketSession::write_close() {
  stream_.async_close(*closing_, [self = shared_from_this()](Error) { self->drop(); });
}

void SocketSession::look_after(double now) {
  std::optional<double> closing_since;
  {
    const std::lock_guard lock(mutex_);
    // The client said goodbye, or broke the protocol and was told so: neither waits for it to close.
    if (!stream_.is_open() && !closing_since_) closing_since_ = now;
    closing_since = closing_since_;
  }
  const Limits& limits = core_.limits;
  if (closing_since) {
    if (now - *closing_since > limits.close_time) drop();
  } else if (writing_since_) {
    if (now - *writing_since_ > limits.stalled_time) {
      core_.logger.debug("{}: socket {} takes nothing", opening_.peer, id_);
      drop();
    }
  } else if (now - heard_ > limits.idle_time) {
    core_.logger.debug("{}: socket {} is silent", opening_.peer, id_);
    drop();
  } else if (now - heard_ > limits.idle_time / 2 && !is_pinging_) {
    is_pinging_ = true;
    stream_.async_ping({}, [self = shared_from_this()](Error) { self->is_pinging_ = false; });
  }
}

void SocketSession::drop() {
  Error ignored;
  beast::get_lowest_layer(stream_).socket().close(ignored);
}

void SocketSession::finish() {
  if (!std::exchange(is_open_, false)) return;
  {
    const std::lock_guard lock(mutex_);
    if (!closing_) closing_.emplace(websocket::close_code::normal);  // what is still sent goes nowhere
    queue_.clear();
  }
  core_.remove(id_);
  core_.logger.debug("{}: socket {} closed", opening_.peer, id_);
  core_.handler->on_close(id_);
}

}  // namespace bw::web
