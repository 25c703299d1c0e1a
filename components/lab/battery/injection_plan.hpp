// What goes wrong with processes in one drive: seeded, several a drive, as the section `faults` of a graph.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bw {

struct Injection {
  std::string kind;     ///< process_killed, process_stopped, process_spins, process_leaks
  std::string process;  ///< of the graph
  double at = 0.0;      ///< [s] of the launch
};

struct InjectionPlan {
  /// Components by which faults name their processes, the lanes that spin.
  struct Process {
    std::string name, component;
    bool leaks = true;  ///< it has a limit of memory in the graph
  };
  std::vector<Process> processes;
  double first = 6.0;   ///< [s] none before it: all are up by then
  double apart = 9.0;   ///< [s] from one to the next: the robot drives again
  double within = 3.0;  ///< [s] of which each comes at any instant
};

/// The graph whose processes fail, and those of them after which it drives on without a hand.
inline constexpr const char* kInjectedGraph = "hallway";
std::vector<InjectionPlan::Process> processes_that_come_back();

/// The first `count` of this drive.
std::vector<Injection> injections_of(const InjectionPlan& plan, std::uint64_t seed, int count);

/// As a file for --set faults=FILE. `plan` knows the components.
std::string faults_text(const std::vector<Injection>& injections, const InjectionPlan& plan);

}  // namespace bw
