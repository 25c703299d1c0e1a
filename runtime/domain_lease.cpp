#include "runtime/domain_lease.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <stdexcept>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace bw {
namespace {

constexpr int kPortBase = 7400;
constexpr int kPortsOfADomain = 250;

/// The port in the second column of /proc/net/udp, `sl local_address ...` with the address as HEX:HEX; -1:
/// there is none.
int port_in(const std::string& line) {
  const std::size_t number = line.find(':');  // behind the row's number
  const std::size_t colon = number == std::string::npos ? number : line.find(':', number + 1);
  return colon == std::string::npos ? -1 : std::stoi(line.substr(colon + 1, 4), nullptr, 16);
}

/// An open socket of that name; -1: somebody has it.
int open_name(const std::string& name) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  // Its first character stays zero: an abstract name.
  if (name.size() + 1 > sizeof(address.sun_path)) throw std::runtime_error(name + ": too long for a lease");
  std::ranges::copy(name, static_cast<char*>(address.sun_path) + 1);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  const int descriptor = socket(AF_UNIX, SOCK_DGRAM, 0);
  if (descriptor < 0) throw std::runtime_error("no socket for the lease of a domain");
  if (bind(descriptor, reinterpret_cast<const sockaddr*>(&address), size) == 0) return descriptor;
  close(descriptor);
  return -1;
}

}  // namespace

std::set<int> domains_in_use() {
  std::set<int> domains;
  for (const char* path : {"/proc/net/udp", "/proc/net/udp6"}) {
    std::ifstream table(path);
    std::string line;
    // A kernel without IPv6 has no second table.
    if (!std::getline(table, line) && std::string(path) == "/proc/net/udp")
      throw std::runtime_error(std::string(path) + ": cannot be read");
    while (std::getline(table, line)) {
      if (const int port = port_in(line); port >= kPortBase)
        domains.insert((port - kPortBase) / kPortsOfADomain);
    }
  }
  return domains;
}

DomainLease::DomainLease(const std::string& name) {
  for (; domain_ >= kLastDomain; --domain_) {
    socket_ = open_name(name + std::to_string(domain_));
    if (socket_ < 0) continue;
    // In this order: whoever leased it before is gone, and what it left behind would show its ports.
    if (!domains_in_use().contains(domain_)) return;
    close(socket_);
  }
  throw std::runtime_error("no DDS domain is free: each from 1 to 100 is leased or has open ports");
}

DomainLease::~DomainLease() { close(socket_); }

}  // namespace bw
