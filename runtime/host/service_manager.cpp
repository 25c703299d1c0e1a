#include "runtime/host/service_manager.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "runtime/host/statistics.hpp"

namespace bw {
namespace {

/// Nothing where it is unset or no number.
std::int64_t number(const char* variable) {
  const char* text = std::getenv(variable);
  std::int64_t value = 0;
  if (text != nullptr) std::from_chars(text, text + std::strlen(text), value);
  return value;
}

constexpr std::int64_t kLongestWatchdog = 3'600'000'000;  // [us]

}  // namespace

ServiceManager::ServiceManager() {
  const char* address = std::getenv("NOTIFY_SOCKET");
  if (address == nullptr || (*address != '/' && *address != '@')) return;
  if (std::strlen(address) >= sizeof(sockaddr_un::sun_path)) return;
  address_ = address;
  socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const std::int64_t pid = number("WATCHDOG_PID");  // another process's, inherited
  const std::int64_t microseconds = number("WATCHDOG_USEC");
  if ((pid == 0 || pid == getpid()) && microseconds > 0 && microseconds <= kLongestWatchdog)
    watchdog_ = Duration{microseconds * 1000};
}

ServiceManager::~ServiceManager() {
  if (socket_ >= 0) close(socket_);
}

std::string ServiceManager::predecessor() {
  const char* text = std::getenv("BANDWAGON_STARTED_AGAIN");
  return text == nullptr ? "" : text;
}

bool ServiceManager::is_launched() { return std::getenv("NOTIFY_SOCKET") != nullptr; }

std::optional<Duration> ServiceManager::since_launch() {
  const std::int64_t began =
      number("BANDWAGON_LAUNCHED_AT");  // [ns] on the steady clock, which processes share
  if (began == 0) return std::nullopt;
  return std::max(Duration{}, steady_time() - Duration{began});
}

void ServiceManager::send(std::string_view state, std::string_view status) const {
  if (socket_ < 0) return;
  sockaddr_un to{};
  to.sun_family = AF_UNIX;
  std::memcpy(to.sun_path, address_.data(), address_.size());
  if (address_.front() == '@') to.sun_path[0] = '\0';
  std::string text(state);
  if (!status.empty()) {
    if (!text.empty()) text += '\n';
    text += "STATUS=";
    text += status.substr(0, status.find('\n'));
  }
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + address_.size());
  static_cast<void>(sendto(socket_, text.data(), text.size(), MSG_NOSIGNAL,
                           reinterpret_cast<const sockaddr*>(&to), length));
}

}  // namespace bw
