#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/socket.h>

#include "runtime/cli/doctor_devices.hpp"
#include "runtime/cli/doctor_report.hpp"
#include "runtime/cli/outside.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/dds/library.hpp"
#include "runtime/dds/loopback_sockets.hpp"
#include "runtime/host/real_time.hpp"

namespace bw::cli {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

void check_environment(DoctorReport& report) {
  for (const char* name :
       {"ROS_DOMAIN_ID", "ROS_LOCALHOST_ONLY", "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_STATIC_PEERS",
        "FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"}) {
    if (const std::string value = variable(name); !value.empty())
      report.ok(fmt::format("{} = {}", name, value));
  }
}

void check_receive_buffer(DoctorReport& report) {
  constexpr long kWanted = 2'000'000;  // a map of 1000 x 1000 cells in one burst
  long bytes = 0;
  std::ifstream("/proc/sys/net/core/rmem_max") >> bytes;
  const std::string text = fmt::format("largest socket receive buffer: {} bytes", bytes);
  if (bytes >= kWanted) {
    report.ok(text);
  } else {
    report.warn(text +
                "; large maps to other processes may need several sends. Raise it: sysctl -w "
                "net.core.rmem_max=4194304");
  }
}

void check_shared_memory(DoctorReport& report) {
  std::size_t leftovers = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/shm", error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("fastrtps_") || name.starts_with("fastdds_")) ++leftovers;  // Fast DDS 2, 3
  }
  if (leftovers == 0) {
    report.ok("no shared-memory files of other DDS programs");
  } else {
    report.warn(fmt::format("{} shared-memory files of other DDS programs in /dev/shm (Bandwagon makes none)",
                            leftovers));
  }
}

void check_library(DoctorReport& report) {
  const dds::LibraryVersion version = dds::library_version();
  const std::vector<std::string> faults = dds::known_faults(version);
  const std::string name = "Fast DDS " + dds::to_string(version);
  if (faults.empty()) return report.ok(name);
  report.warn(
      name +
      " has published faults that strangers on the network can use; on loopback only programs of this machine can:");
  for (const std::string& fault : faults) report.warn("  " + fault);
}

void check_discovery(DoctorReport& report) {
  Outside one;
  const dds::Network network = dds::Network::from_environment(dds::Transport::localhost);
  if (network.transport == dds::Transport::localhost) {
    bool all_bound = true;
    for (const int descriptor : dds::open_datagram_sockets()) {
      char device[16] = {};
      socklen_t length = sizeof(device);
      getsockopt(descriptor, SOL_SOCKET, SO_BINDTODEVICE, static_cast<char*>(device), &length);
      all_bound = all_bound && std::string(static_cast<const char*>(device)) == "lo";
    }
    if (all_bound) {
      report.ok("every DDS socket is bound to the loopback device");
    } else {
      report.fail("a DDS socket is open to the network although the transport is localhost");
    }
  } else {
    report.warn("the transport is open to the network (ROS_AUTOMATIC_DISCOVERY_RANGE)");
  }
  Outside two;
  two.settle();
  if (two.participant().remote_participants().empty()) {
    report.fail("two participants of this host do not discover each other");
  } else {
    report.ok(fmt::format("discovery works on domain {}; other programs there: {}", network.domain_id,
                          two.participant().remote_participants().size() - 1));
  }
}

void check_real_time_rights(DoctorReport& report) {
  const std::string missing = missing_real_time_rights();
  if (missing.empty()) {
    report.ok("real-time priority and locked memory are allowed");
  } else {
    report.warn("on a busy machine the base may be commanded late: " + missing);
  }
}

struct DoctorOptions {
  bool ports = false;
  std::string graph;
  std::vector<std::string> set;
};

int examine(const DoctorOptions& options) {
  DoctorReport report(std::cout);
  if (!options.ports && options.graph.empty()) {
    check_library(report);
    check_environment(report);
    check_receive_buffer(report);
    check_shared_memory(report);
    check_discovery(report);
  }
  if (options.graph.empty()) check_serial_devices(report);
  if (!options.graph.empty()) check_ports(report, ports_of(load_graph(options.graph, options.set)));
  check_real_time_rights(report);
  return report.status();
}

void add_doctor(Verb doctor) {
  auto options = std::make_shared<DoctorOptions>();
  doctor.flag("--ports", options->ports, "Only serial ports and real-time rights");
  const Option graph = doctor.option("--graph", options->graph,
                                     "Only whether the ports of its robot can be opened; status 1 when not");
  doctor.option("--set", options->set, "component.param=value").one_each_time().needs(graph);
  doctor.run([options] { return examine(*options); });
}

}  // namespace

BW_VERB(look, "doctor",
        "Checks this machine: sockets, discovery, buffers, leftovers, serial ports, real-time rights",
        add_doctor)

}  // namespace bw::cli
