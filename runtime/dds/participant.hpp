// The border to DDS: raw CDR samples in and out, and what discovery sees. This header and everything above it
// knows no Fast DDS; only the sources in runtime/dds do. Failures while creating anything are
// std::runtime_error.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/graph/qos.hpp"

namespace bw::dds {

using Guid = std::array<std::uint8_t, 16>;  ///< 12 bytes of participant prefix, 4 of entity id

bool same_participant(const Guid& a, const Guid& b);
/// Both are of Fast DDS, which puts a number of the host behind its vendor id. Other vendors' GIDs do not
/// tell: false.
bool same_host(const Guid& a, const Guid& b);

enum class Transport {
  localhost,  ///< discovery and data on 127.0.0.1 only, sockets bound to the loopback device
  lan,        ///< multicast discovery on every interface
};

/// What the environment says, with ROS 2's variables: ROS_DOMAIN_ID, ROS_LOCALHOST_ONLY,
/// ROS_AUTOMATIC_DISCOVERY_RANGE, ROS_STATIC_PEERS.
struct Network {
  int domain_id = 0;
  Transport transport = Transport::localhost;
  std::vector<std::string> static_peers;  ///< IPv4 addresses tried on every participant port

  /// Reads the variables over `configured`; ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET opens, LOCALHOST, OFF and
  /// ROS_LOCALHOST_ONLY=1 close.
  static Network from_environment(Transport configured);
};

struct ParticipantOptions {
  Network network;
  std::string name = "/";  ///< ROS enclave
  /// Non-empty: readers of this participant match only its own writers (lock-step), while outside readers
  /// still see the writers. What is in this partition goes by a bus within the process (bus.hpp), not by DDS.
  std::string private_partition = {};
  /// Nobody is heard and nobody is told, whatever the network says: there is no DDS, everything goes by the bus.
  bool alone = false;
  /// Of each socket; the kernel gives at most net.core.rmem_max. 0: its default [bytes].
  std::uint32_t receive_buffer = 0;
};

/// One endpoint as discovery shows it.
struct Endpoint {
  Guid guid{};
  bool is_writer = false;
  bool is_local = false;  ///< belongs to this participant
  std::string topic;      ///< DDS name, such as rt/odom
  std::string type;       ///< DDS name, such as nav_msgs::msg::dds_::Odometry_
  Qos qos;
  std::string user_data;                     ///< typehash=RIHS01_...;
  std::vector<std::string> partitions = {};  ///< none: that of every ordinary endpoint
};

/// For what is written as soon as the other side is known: it may not know us yet, drops the sample, and is
/// told of it again by the next heartbeat alone.
inline constexpr Duration kPromptHeartbeat = Duration::milliseconds(100);

struct EndpointOptions {
  std::string topic;  ///< DDS name
  std::string type;   ///< DDS name
  Qos qos;
  std::string user_data;
  /// Of a reliable writer: so often readers that lack something are told; nothing: every 3 s.
  std::optional<Duration> heartbeat = std::nullopt;
  /// "" is that of every ordinary endpoint; empty: the participant's.
  std::vector<std::string> partitions = {};
  /// Samples that memory is taken for beforehand; more come as they are needed.
  int allocated_samples = 100;
};

/// By which a reply finds its request: whom to answer, and the count of the request at its writer. On the
/// wire it is the related sample identity (PID 0x800f).
struct SampleIdentity {
  Guid guid{};
  std::int64_t sequence = 0;
  auto operator<=>(const SampleIdentity&) const = default;
};

/// One received sample: CDR with its 4-byte encapsulation header.
struct Sample {
  std::vector<std::uint8_t> cdr;
  Guid writer{};
  std::uint64_t sequence = 0;  ///< the writer's count of its samples: a gap is a loss
  SampleIdentity related;      ///< of a request or reply; zeros otherwise
  Time received;               ///< system clock
  Time sent;                   ///< the writer's system clock; 0 when it does not tell
};

class Writer {
 public:
  virtual ~Writer() = default;
  /// Copies the bytes out before it returns. False when DDS refused the sample.
  virtual bool write(std::span<const std::uint8_t> cdr) = 0;
  /// A request or a reply. The identity of the sample itself; nothing when DDS refused it.
  virtual std::optional<SampleIdentity> write_related(std::span<const std::uint8_t> cdr,
                                                      const SampleIdentity& related) = 0;
  virtual Guid guid() const = 0;
  virtual int matched_readers() const = 0;
  /// The reader gets what is written from now on.
  virtual bool is_matched(const Guid& reader) const = 0;
  /// Waits until all reliable readers have everything; false when they have not after `limit`.
  virtual bool wait_until_received(Duration limit) = 0;
};

class Reader {
 public:
  virtual ~Reader() = default;
  /// The oldest waiting sample; false when there is none.
  virtual bool take(Sample& sample) = 0;
  virtual Guid guid() const = 0;
  virtual int matched_writers() const = 0;
};

/// The one DomainParticipant of a process.
class Participant {
 public:
  explicit Participant(const ParticipantOptions& options);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// `on_match`, if any, runs on a DDS thread when a reader has come or gone: it may only enqueue.
  std::unique_ptr<Writer> create_writer(const EndpointOptions& options,
                                        std::function<void()> on_match = nullptr);
  /// `on_sample` runs on a DDS thread with endpoint locks held: it may only enqueue. So does `on_match`, if
  /// any, when a writer has come or gone.
  std::unique_ptr<Reader> create_reader(const EndpointOptions& options, std::function<void()> on_sample,
                                        std::function<void()> on_match = nullptr);

  Guid guid() const;
  const std::string& private_partition() const;
  /// Every endpoint known now, own and remote, sorted by topic, kind and guid.
  std::vector<Endpoint> endpoints() const;
  /// Remote writers that have left since the last call, so that one that came and went between two looks at
  /// endpoints() is not missed; the first 256 of them.
  std::vector<Endpoint> take_departed();
  /// Counts the changes of endpoints(): cheap to look at often.
  std::uint64_t endpoint_changes() const;
  /// For how long the participant of a remote endpoint counts as there after its last sign of life; nothing:
  /// the endpoint is not there.
  std::optional<Duration> lease_of(const Guid& endpoint) const;
  /// Remote participants alive now.
  std::vector<Guid> remote_participants() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bw::dds
