// Ties sockets to the loopback device, so that no packet from a network reaches them whatever address they
// listen on.
#pragma once

#include <set>

namespace bw::dds {

/// File descriptors of all IPv4 datagram sockets this process has open.
std::set<int> open_datagram_sockets();

/// Binds each socket that is still open to the device "lo". Throws std::runtime_error naming the cause when
/// the kernel refuses.
void bind_to_loopback(const std::set<int>& sockets);

}  // namespace bw::dds
