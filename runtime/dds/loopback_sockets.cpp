#include "runtime/dds/loopback_sockets.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <netinet/in.h>
#include <sys/socket.h>

namespace bw::dds {
namespace {

bool is_ipv4_datagram(int descriptor) {
  int domain = 0;
  int type = 0;
  socklen_t length = sizeof(domain);
  if (getsockopt(descriptor, SOL_SOCKET, SO_DOMAIN, &domain, &length) != 0 || domain != AF_INET) return false;
  length = sizeof(type);
  return getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &length) == 0 && type == SOCK_DGRAM;
}

}  // namespace

std::set<int> open_datagram_sockets() {
  std::set<int> sockets;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const std::string name = entry.path().filename().string();
    int descriptor = -1;
    std::from_chars(name.data(), name.data() + name.size(), descriptor);
    if (is_ipv4_datagram(descriptor)) sockets.insert(descriptor);
  }
  return sockets;
}

void bind_to_loopback(const std::set<int>& sockets) {
  for (const int descriptor : sockets) {
    if (setsockopt(descriptor, SOL_SOCKET, SO_BINDTODEVICE, "lo", 3) != 0) {
      if (errno == EBADF || errno == ENOTSOCK) continue;  // another thread has closed it meanwhile
      throw std::runtime_error(std::string("cannot bind a DDS socket to the loopback device: ") +
                               std::strerror(errno));
    }
  }
}

}  // namespace bw::dds
