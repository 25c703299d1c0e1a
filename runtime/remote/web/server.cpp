#include "runtime/remote/web/server.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include <boost/asio/dispatch.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>

#include "runtime/remote/web/http_session.hpp"
#include "runtime/remote/web/socket_session.hpp"
#include "runtime/thrown.hpp"

namespace bw::web {
namespace {

namespace net = boost::asio;
using net::ip::tcp;
using Error = boost::system::error_code;

constexpr std::chrono::milliseconds kFarewell{300};   // for sockets to hear that the server stops
constexpr std::chrono::milliseconds kAcceptRest{50};  // where the system gives no more sockets

net::ip::address parsed_address(const ServerOptions& options) {
  Error error;
  const auto address = net::ip::make_address(options.address, error);
  if (error) {
    throw std::runtime_error(fmt::format("address: `{}` is no IP address, as 127.0.0.1 is", options.address));
  }
  if (!address.is_loopback() && options.token_file.empty()) {
    throw std::runtime_error(fmt::format(
        "address: {} can be reached from other machines: a token_file is needed", options.address));
  }
  return address;
}

}  // namespace

std::shared_ptr<SocketSession> Core::find(ConnectionId id) const {
  const std::lock_guard lock(mutex_);
  const auto known = sessions_.find(id);
  return known == sessions_.end() ? nullptr : known->second;
}

void Core::add(ConnectionId id, std::shared_ptr<SocketSession> session) {
  const std::lock_guard lock(mutex_);
  sessions_.emplace(id, std::move(session));
}

void Core::remove(ConnectionId id) {
  const std::lock_guard lock(mutex_);
  sessions_.erase(id);
}

std::vector<std::shared_ptr<SocketSession>> Core::all() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<SocketSession>> sessions;
  for (const auto& [id, session] : sessions_) sessions.push_back(session);
  return sessions;
}

class Server::Impl {
 public:
  Impl(const ServerOptions& options, Site site, std::vector<std::string> subprotocols, Logger logger)
      : ip_(parsed_address(options)),
        core_(options, ip_.is_loopback(), std::move(site), std::move(subprotocols), std::move(logger)),
        work_(net::make_work_guard(core_.io)),
        acceptor_(core_.io),
        accept_timer_(core_.io),
        care_timer_(core_.io) {
    listen(options);
    core_.router.set_port(port());
  }
  ~Impl() { stop(); }

  void start(SocketHandler& handler) {
    core_.handler = &handler;
    net::post(core_.io, [this] {
      accept();
      look_after();
    });
    thread_ = std::thread([this] { run(); });
  }

  void stop() {
    if (!thread_.joinable()) return;
    net::post(core_.io, [this] { say_farewell(); });
    thread_.join();
    for (const auto& session : core_.all()) {
      session->drop();
      session->finish();
    }
  }

  std::uint16_t port() const { return port_; }
  std::string url() const {
    const std::string host = ip_.is_v6() ? '[' + ip_.to_string() + ']' : ip_.to_string();
    return fmt::format("http://{}:{}/", host, port_);
  }
  Core& core() { return core_; }

 private:
  void listen(const ServerOptions& options);
  void run();
  void accept();
  void on_accepted(Error error, tcp::socket socket);
  void look_after();
  void say_farewell();
  void wait_for_the_last();

  net::ip::address ip_;
  Core core_;
  net::executor_work_guard<net::io_context::executor_type> work_;
  tcp::acceptor acceptor_;
  net::steady_timer accept_timer_;
  bool is_out_of_descriptors_ = false;  ///< and that was told
  net::steady_timer care_timer_;
  std::chrono::steady_clock::time_point farewell_end_;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

void Server::Impl::listen(const ServerOptions& options) {
  const int tries = options.port == 0 ? 1 : options.port_tries;
  Error error;
  for (int i = 0; i < tries && options.port + i <= 65535; ++i) {
    const tcp::endpoint end(ip_, static_cast<std::uint16_t>(options.port + i));
    acceptor_.open(end.protocol(), error);
    if (!error) acceptor_.set_option(net::socket_base::reuse_address(true), error);
    if (!error) acceptor_.bind(end, error);
    if (!error) acceptor_.listen(net::socket_base::max_listen_connections, error);
    if (!error) {
      port_ = acceptor_.local_endpoint().port();
      return;
    }
    Error ignored;
    acceptor_.close(ignored);
    if (error != net::error::address_in_use) break;
  }
  throw std::runtime_error(fmt::format("{}: no port to listen on, from {} on {} tried: {}", options.address,
                                       options.port, tries, error.message()));
}

void Server::Impl::run() {
  while (true) {
    try {
      core_.io.run();
      return;
    } catch (...) {
      core_.logger.error("page server: {}", thrown_text());
    }
  }
}

void Server::Impl::accept() {
  acceptor_.async_accept(core_.io,
                         [this](Error error, tcp::socket socket) { on_accepted(error, std::move(socket)); });
}

void Server::Impl::on_accepted(Error error, tcp::socket socket) {
  if (core_.is_stopping) return;
  if (error) {  // no more file descriptors, or a client that went while it waited
    if (error == net::error::no_descriptors && !std::exchange(is_out_of_descriptors_, true))
      core_.logger.warn("no file descriptor is free: who connects waits until one is");
    accept_timer_.expires_after(kAcceptRest);
    accept_timer_.async_wait([this](Error stopped) {
      if (!stopped) accept();
    });
    return;
  }
  is_out_of_descriptors_ = false;
  Error ignored;
  if (core_.connections >= core_.limits.connections) {
    constexpr std::string_view kFull =
        "HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\nContent-Length: 0\r\n\r\n";
    socket.non_blocking(true, ignored);
    socket.write_some(net::buffer(kFull), ignored);
    core_.logger.debug("a connection more than {}: closed", core_.limits.connections);
  } else {
    socket.set_option(tcp::no_delay(true), ignored);
    std::make_shared<HttpSession>(core_, std::move(socket))->read_request();
  }
  accept();
}

void Server::Impl::look_after() {
  const double shortest = std::min(core_.limits.idle_time / 8, core_.limits.close_time / 2);
  care_timer_.expires_after(to_chrono(std::clamp(shortest, 0.01, 1.0)));
  care_timer_.async_wait([this](Error stopped) {
    if (stopped || core_.is_stopping) return;
    const double now = now_in_seconds();
    for (const auto& session : core_.all()) session->look_after(now);
    look_after();
  });
}

void Server::Impl::say_farewell() {
  core_.is_stopping = true;
  Error ignored;
  acceptor_.close(ignored);
  accept_timer_.cancel();
  care_timer_.cancel();
  for (HttpSession* session : core_.waiting) session->drop();
  for (const auto& session : core_.all()) session->close(1001, "the server stops", true);
  farewell_end_ = std::chrono::steady_clock::now() + kFarewell;
  wait_for_the_last();
}

void Server::Impl::wait_for_the_last() {
  if (core_.all().empty() || std::chrono::steady_clock::now() > farewell_end_) {
    core_.io.stop();
    return;
  }
  care_timer_.expires_after(std::chrono::milliseconds(5));
  care_timer_.async_wait([this](Error) { wait_for_the_last(); });
}

Server::Server(const ServerOptions& options, Site site, std::vector<std::string> subprotocols, Logger logger)
    : impl_(std::make_unique<Impl>(options, std::move(site), std::move(subprotocols), std::move(logger))) {}
Server::~Server() = default;

void Server::start(SocketHandler& handler) { impl_->start(handler); }
void Server::stop() { impl_->stop(); }
std::uint16_t Server::port() const { return impl_->port(); }
std::string Server::address() const { return impl_->url(); }
std::string Server::run_token() const { return impl_->core().router.run_token(); }

void Server::send(ConnectionId id, Frame frame, Keep keep) {
  if (const auto session = impl_->core().find(id)) session->send(std::move(frame), keep);
}

void Server::close(ConnectionId id, std::uint16_t code, const std::string& reason) {
  if (const auto session = impl_->core().find(id)) session->close(code, reason);
}

void Server::post(std::function<void()> call) { net::post(impl_->core().io, std::move(call)); }

void Server::after(std::chrono::milliseconds delay, std::function<void()> call) {
  auto timer = std::make_shared<net::steady_timer>(impl_->core().io, delay);
  timer->async_wait([timer, call = std::move(call)](Error error) {
    if (!error) call();
  });
}

}  // namespace bw::web
