// One DDS participant that behaves as a process of ROS 2 with one node: found as ROS 2's tools are found on
// one machine, its ends announced as rmw_fastrtps announces them, and a view of what others announce.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "runtime/dds/fast_dds.hpp"
#include "tests/interop/plain/wire.hpp"

namespace plain {

namespace dds = bw::fast_dds::dds;
namespace rtps = bw::fast_dds::rtps;

using Gid = std::array<std::uint8_t, 16>;
Gid to_gid(const rtps::GUID_t& guid);

/// A writer or reader as discovery tells it.
struct End {
  std::string topic;
  std::string type;
  std::string user_data;
  bool is_writer = false;
  bool is_reliable = false;
  bool is_volatile = false;
  bool is_own = false;
};

/// Bytes of an id in ros_discovery_info.
enum class GidSize : std::size_t { iron_and_later = 16, humble = 24 };

/// A node of another participant, as it lists its ends itself.
struct NodeInfo {
  std::string name;  ///< with its namespace: /robot1/planner
  std::set<Gid> readers;
  std::set<Gid> writers;
};

struct EndOptions {
  std::string topic;
  std::string type;
  std::string type_hash;  ///< RIHS01_...; empty: none is told, as Humble
  int depth = 10;
  int entity_id = -1;       ///< -1: the next free one
  bool is_latched = false;  ///< transient local
};

class Node {
 public:
  /// With `wire` every datagram received is kept there.
  explicit Node(std::string name, std::shared_ptr<Wire> wire = nullptr,
                GidSize gid_size = GidSize::iron_and_later);
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// Reliable, and volatile unless latched, as rmw's services. Deleted with remove(), or with the node.
  dds::DataWriter* create_writer(const EndOptions& options, dds::DataWriterListener* listener = nullptr);
  dds::DataReader* create_reader(const EndOptions& options);
  void remove(dds::DataWriter* writer);
  void remove(dds::DataReader* reader);
  /// Tells the others which ends the node has. After every change.
  void announce();

  std::map<Gid, End> ends() const;
  /// Of a topic in the whole graph, own ones too.
  int count(const std::string& topic, bool is_writer) const;
  /// Participants whose lease ran out: they left without a word.
  int expired() const;
  /// Nodes of other participants, by the newest message of each; their GIDs have the size of our own.
  std::vector<NodeInfo> nodes();
  rtps::GUID_t guid() const;

 private:
  class Listener;
  dds::Topic* topic(const std::string& name, const std::string& type);
  End described(const EndOptions& options, bool is_writer) const;

  std::string name_;
  GidSize gid_size_;
  std::unique_ptr<Listener> listener_;
  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
  std::set<Gid> readers_, writers_;
  dds::DataWriter* graph_writer_ = nullptr;
  dds::DataReader* graph_reader_ = nullptr;
  std::map<Gid, std::vector<NodeInfo>> nodes_;  ///< by participant
};

}  // namespace plain
