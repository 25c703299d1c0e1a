#include "runtime/supervisor/credential_socket.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <vector>

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace bw {
namespace {

constexpr std::size_t kLargest = 65'536;

struct Address {
  sockaddr_un raw{};
  socklen_t length = sizeof(sa_family_t);

  [[nodiscard]] const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&raw); }
};

/// `name` is a path, or the bytes of an abstract name with its leading zero.
Address address_of(const std::string& name) {
  Address address;
  address.raw.sun_family = AF_UNIX;
  if (name.size() >= sizeof(address.raw.sun_path))
    throw std::runtime_error(name + ": too long for a socket; set XDG_RUNTIME_DIR to a shorter folder");
  std::memcpy(address.raw.sun_path, name.data(), name.size());
  address.length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  return address;
}

/// Of the control messages, the sender's.
ucred credentials_of(msghdr& message) {
  ucred sender{};
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level == SOL_SOCKET && part->cmsg_type == SCM_CREDENTIALS)
      std::memcpy(&sender, CMSG_DATA(part), sizeof(sender));
  }
  return sender;
}

}  // namespace

CredentialSocket::CredentialSocket(const std::filesystem::path& path)
    : path_(path), socket_(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  const int on = 1;
  const Address address = address_of(path.string());
  unlink(path.c_str());
  if (socket_ < 0 || fchmod(socket_, 0600) != 0 ||
      setsockopt(socket_, SOL_SOCKET, SO_PASSCRED, &on, sizeof(on)) != 0 ||
      bind(socket_, address.get(), address.length) != 0) {
    const std::string reason = std::strerror(errno);
    if (socket_ >= 0) close(socket_);
    throw std::runtime_error(path.string() + ": " + reason);
  }
}

CredentialSocket::~CredentialSocket() {
  close(socket_);
  unlink(path_.c_str());
}

std::optional<CredentialSocket::Datagram> CredentialSocket::receive() const {
  std::vector<char> text(kLargest);
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(ucred))] = {};
  sockaddr_un from{};
  iovec part{.iov_base = text.data(), .iov_len = text.size()};
  msghdr message{};
  message.msg_name = &from;
  message.msg_namelen = sizeof(from);
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof(control);
  const ssize_t size = recvmsg(socket_, &message, MSG_CMSG_CLOEXEC);
  if (size < 0) return std::nullopt;
  const ucred sender = credentials_of(message);
  const auto head = offsetof(sockaddr_un, sun_path);
  const std::size_t length = message.msg_namelen > head ? message.msg_namelen - head : 0;
  return Datagram{.pid = sender.pid,
                  .uid = sender.uid,
                  .text = std::string(text.data(), static_cast<std::size_t>(size)),
                  .from = std::string(static_cast<const char*>(from.sun_path), length)};
}

void CredentialSocket::answer(const Datagram& question, const std::string& text) const {
  if (question.from.empty()) return;
  const Address to = address_of(question.from);
  static_cast<void>(sendto(socket_, text.data(), std::min(text.size(), kLargest), MSG_NOSIGNAL | MSG_DONTWAIT,
                           to.get(), to.length));
}

std::optional<std::string> CredentialSocket::ask(const std::filesystem::path& path, const std::string& text,
                                                 std::chrono::milliseconds patience) {
  const Address to = address_of(path.string());
  const int mine = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const Address any{.raw = {.sun_family = AF_UNIX, .sun_path = {}}};  // the kernel finds a name
  std::vector<char> answer(kLargest);
  ssize_t size = -1;
  if (bind(mine, any.get(), any.length) == 0 &&
      sendto(mine, text.data(), text.size(), MSG_NOSIGNAL, to.get(), to.length) >= 0) {
    pollfd waiting{.fd = mine, .events = POLLIN, .revents = 0};
    if (poll(&waiting, 1, static_cast<int>(patience.count())) == 1)
      size = recv(mine, answer.data(), answer.size(), 0);
  }
  close(mine);
  if (size < 0) return std::nullopt;
  return std::string(answer.data(), static_cast<std::size_t>(size));
}

}  // namespace bw
