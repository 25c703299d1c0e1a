// Goals as `ros2 topic pub --once /goal_pose` sends them: a participant appears, waits for a reader, sends
// one goal and leaves a tenth of a second later. Each goal comes from a process of its own, as the tool is
// one; the x of the k-th goal is k.
//
//   goal_once humble|jazzy FIRST COUNT
//
// Prints a line for each goal: sent K, or unmatched K when no reader came within 10 s. The domain is
// ROS_DOMAIN_ID; no packet leaves 127.0.0.1.
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include "runtime/dds/fast_dds.hpp"

namespace {

using namespace bw::fast_dds::dds;
namespace rtps = bw::fast_dds::rtps;

constexpr auto kStay = std::chrono::milliseconds(100);  // the tool's --keep-alive
constexpr auto kPatience = std::chrono::seconds(10);

using Bytes = std::vector<std::uint8_t>;

template <class T>
void append(Bytes& bytes, T value) {
  std::uint8_t raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.insert(bytes.end(), raw, raw + sizeof(T));
}

/// geometry_msgs/PoseStamped at (x, 0) in map, as CDR lays it out on a little-endian machine.
Bytes goal(double x) {
  Bytes bytes = {0, 1, 0, 0};
  append<std::int32_t>(bytes, 0);  // stamp: 0 means the newest transform
  append<std::uint32_t>(bytes, 0);
  append<std::uint32_t>(bytes, 4);  // with its NUL
  for (const char c : {'m', 'a', 'p', '\0'}) append(bytes, c);
  for (const double value : {x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) append(bytes, value);
  return bytes;
}

class PoseStampedType final : public bw::fast_dds::SerializedType {
 public:
  PoseStampedType() : SerializedType("geometry_msgs::msg::dds_::PoseStamped_", 128) {}
  std::span<const std::uint8_t> bytes_of(const void* sample) const override {
    return *static_cast<const Bytes*>(sample);
  }
  void assign(void*, std::span<const std::uint8_t>) const override {}
  void* create() const override { return new Bytes; }
  void destroy(void* sample) const override { delete static_cast<Bytes*>(sample); }
};

/// As rmw_fastrtps sets up a participant that keeps to this machine: Humble by multicast on a white-listed
/// loopback device, Jazzy by asking 127.0.0.1 port by port.
DomainParticipantQos participant_qos(bool is_humble) {
  DomainParticipantQos qos = PARTICIPANT_QOS_DEFAULT;
  auto udp = std::make_shared<bw::fast_dds::transport::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.push_back("127.0.0.1");
  if (!is_humble) {
    udp->maxInitialPeersRange = 32;
    rtps::Locator_t loopback;
    rtps::IPLocator::setIPv4(loopback, "127.0.0.1");
    qos.wire_protocol().builtin.initialPeersList.push_back(loopback);
    qos.wire_protocol().builtin.metatrafficUnicastLocatorList.push_back(loopback);
  }
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  return qos;
}

class Match final : public DataWriterListener {
 public:
  void on_publication_matched(DataWriter*, const PublicationMatchedStatus& status) override {
    const std::lock_guard lock(mutex_);
    readers_ = status.current_count;
    changed_.notify_all();
  }
  bool wait() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [this] { return readers_ > 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int readers_ = 0;
};

bool send(bool is_humble, int number, DomainId_t domain) {
  Match match;
  auto* factory = DomainParticipantFactory::get_instance();
  DomainParticipant* participant = factory->create_participant(domain, participant_qos(is_humble));
  if (participant == nullptr) throw std::runtime_error("no participant");
  TypeSupport type(new PoseStampedType);
  type.register_type(participant);
  Topic* topic = participant->create_topic("rt/goal_pose", type.get_type_name(), TOPIC_QOS_DEFAULT);
  Publisher* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
  DataWriterQos qos = DATAWRITER_QOS_DEFAULT;
  qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = is_humble ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = is_humble ? 1 : 10;
  qos.data_sharing().off();
  qos.publish_mode().kind = SYNCHRONOUS_PUBLISH_MODE;
  DataWriter* writer = publisher->create_datawriter(topic, qos, &match, StatusMask::publication_matched());
  const bool is_matched = match.wait();
  if (is_matched) {
    Bytes bytes = goal(number);
    bw::fast_dds::write(*writer, &bytes);
    std::this_thread::sleep_for(kStay);
  }
  writer->set_listener(nullptr);
  participant->delete_contained_entities();
  factory->delete_participant(participant);
  return is_matched;
}

}  // namespace

int main(int count_of_arguments, char** arguments) {
  if (count_of_arguments != 4) {
    std::cerr << "usage: goal_once humble|jazzy FIRST COUNT\n";
    return 2;
  }
  const bool is_humble = std::string(arguments[1]) == "humble";
  const int first = std::atoi(arguments[2]);
  const char* domain = std::getenv("ROS_DOMAIN_ID");
  for (int number = first; number < first + std::atoi(arguments[3]); ++number) {
    const pid_t child = fork();
    if (child == 0) {
      const bool sent =
          send(is_humble, number, static_cast<DomainId_t>(domain == nullptr ? 0 : std::atoi(domain)));
      std::cout << (sent ? "sent " : "unmatched ") << number << std::endl;
      return 0;
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) return 1;
  }
}
