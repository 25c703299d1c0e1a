// service_graph as a child process of a test.
#pragma once

#include <csignal>
#include <fstream>
#include <string>
#include <string_view>

#include "tests/interop/plain/service.hpp"
#include "tests/interop/process.hpp"
#include "tests/interop/service_golden.hpp"

namespace bw::test {

class ServiceProcess {
 public:
  explicit ServiceProcess(const std::string& role) : process_({SERVICE_GRAPH, role}) {}

  Process& process() { return process_; }
  /// Memory in use [MB].
  double memory_mb() const {
    std::ifstream status("/proc/" + std::to_string(process_.id()) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024.0;
    }
    return -1.0;
  }
  /// Its exit status.
  int stop() {
    process_.signal(SIGTERM);
    return process_.wait(std::chrono::seconds(20)).value_or(-1);
  }

 private:
  Process process_;
};

inline plain::ServiceType plain_type(const Golden& golden) {
  return {golden.type, "RIHS01_" + golden.request_hash, "RIHS01_" + golden.response_hash};
}

inline const Golden& golden_of(std::string_view service) {
  for (const Golden& entry : golden()) {
    if (entry.service == service) return entry;
  }
  throw std::logic_error("no golden bytes of " + std::string(service));
}

}  // namespace bw::test
