// What came over UDP, as it came: a transport that keeps a copy of every datagram, and a reader of RTPS (OMG
// formal/2019-04-03,
// 9.4) that finds the samples in it.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "runtime/dds/fast_dds.hpp"
#include "tests/interop/plain/cdr.hpp"

namespace plain {

/// A DATA submessage.
struct Data {
  std::array<std::uint8_t, 16> writer{};  ///< GUID
  std::int64_t sequence = 0;
  std::map<std::uint16_t, Bytes> inline_qos;  ///< by parameter id
  Bytes payload;
};

/// The DATA submessages of one datagram; none when it is no RTPS.
std::vector<Data> data_in(const Bytes& datagram);

/// A place where datagrams are kept. From any thread.
class Wire {
 public:
  void keep(Bytes datagram);
  /// Of one writer, in the order in which they came; those sent again appear again.
  std::vector<Data> data_of(const std::array<std::uint8_t, 16>& writer) const;

 private:
  mutable std::mutex mutex_;
  std::vector<Bytes> datagrams_;
};

/// UDPv4 below, every datagram received also to `wire`.
std::shared_ptr<bw::fast_dds::transport::TransportDescriptorInterface> recorded(
    std::shared_ptr<bw::fast_dds::transport::TransportDescriptorInterface> below, std::shared_ptr<Wire> wire);

}  // namespace plain
