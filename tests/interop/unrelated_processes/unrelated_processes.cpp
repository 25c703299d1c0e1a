// unrelated_processes [COUNT]: somebody else's ROS 2 on this machine, as tests may have it beside them: a
// participant on each of COUNT (10) domains, the first that a test would lease. They write what robots write,
// know each other by shared memory and UDP on 127.0.0.1, and hold the port of a page. Prints the domains in
// one line once all are there; ends by SIGINT or SIGTERM.
#include <array>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <list>
#include <memory>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "runtime/dds/fast_dds.hpp"
#include "runtime/domain_lease.hpp"
#include "tests/interop/plain/octets_type.hpp"

namespace {

namespace dds = bw::fast_dds::dds;

struct Said {
  const char* topic;
  const char* type;
  std::size_t size;  ///< [bytes] of zeros behind the encapsulation
};
constexpr std::array<Said, 3> kSaid = {{{"rt/cmd_vel", "geometry_msgs::msg::dds_::Twist_", 48},
                                        {"rt/clock", "rosgraph_msgs::msg::dds_::Clock_", 8},
                                        {"rt/tf", "tf2_msgs::msg::dds_::TFMessage_", 4}}};

dds::DomainParticipantQos participant_qos() {
  dds::DomainParticipantQos qos = dds::PARTICIPANT_QOS_DEFAULT;
  qos.name("/");
  auto udp = std::make_shared<bw::fast_dds::transport::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.push_back("127.0.0.1");
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {
      udp, std::make_shared<bw::fast_dds::transport::SharedMemTransportDescriptor>()};
  return qos;
}

class ForeignParticipant {
 public:
  explicit ForeignParticipant(int domain) {
    auto* factory = dds::DomainParticipantFactory::get_instance();
    participant_ = factory->create_participant(static_cast<dds::DomainId_t>(domain), participant_qos());
    if (participant_ == nullptr)
      throw std::runtime_error("no participant on domain " + std::to_string(domain));
    dds::Publisher* publisher = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    for (const Said& said : kSaid) {
      dds::TypeSupport(new plain::OctetsType(said.type)).register_type(participant_);
      dds::Topic* topic = participant_->create_topic(said.topic, said.type, dds::TOPIC_QOS_DEFAULT);
      writers_.push_back(publisher->create_datawriter(topic, dds::DATAWRITER_QOS_DEFAULT));
    }
  }
  ~ForeignParticipant() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  ForeignParticipant(const ForeignParticipant&) = delete;
  ForeignParticipant& operator=(const ForeignParticipant&) = delete;
  void speak() {
    for (std::size_t i = 0; i < kSaid.size(); ++i) {
      plain::Bytes bytes(4 + kSaid[i].size);
      bytes[1] = 1;  // CDR, little endian
      writers_[i]->write(&bytes);
    }
  }

 private:
  dds::DomainParticipant* participant_ = nullptr;
  std::vector<dds::DataWriter*> writers_;
};

/// Where the page and Foxglove's bridge listen. Somebody else's being there already is as good.
void hold_the_port_of_a_page() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(8765);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int descriptor = socket(AF_INET, SOCK_STREAM, 0);
  if (bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0)
    listen(descriptor, 1);
}

}  // namespace

int main(int count_of_arguments, char** arguments) {
  const int count = count_of_arguments > 1 ? std::atoi(arguments[1]) : 10;
  // Before there are threads, so that this one alone takes them.
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);
  try {
    std::list<ForeignParticipant> participants;
    {
      std::list<bw::DomainLease> leases;  // so that they come to no test; participants know nothing of leases
      for (int i = 0; i < count; ++i) participants.emplace_back(leases.emplace_back().domain());
      hold_the_port_of_a_page();
      for (const auto& lease : leases) std::cout << lease.domain() << " ";
      std::cout << std::endl;
    }
    const timespec pause{.tv_sec = 0, .tv_nsec = 50'000'000};
    while (sigtimedwait(&ends, nullptr, &pause) < 0) {
      for (ForeignParticipant& participant : participants) participant.speak();
    }
  } catch (const std::exception& e) {
    std::cerr << "participants: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
