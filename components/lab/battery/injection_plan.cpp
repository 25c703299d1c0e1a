#include "components/lab/battery/injection_plan.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "components/model/random.hpp"

namespace bw {

std::vector<InjectionPlan::Process> processes_that_come_back() {
  return {{.name = "planning", .component = "local_planner"}, {.name = "rest", .component = "localization"}};
}

std::vector<Injection> injections_of(const InjectionPlan& plan, std::uint64_t seed, int count) {
  constexpr std::array kKinds = {"process_killed", "process_stopped", "process_spins", "process_leaks"};
  Random random(seed);
  const auto one_of = [&](std::size_t size) {
    return std::min(size - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(size)));
  };
  std::vector<Injection> injections;
  for (int i = 0; i < count; ++i) {
    const InjectionPlan::Process& process = plan.processes[one_of(plan.processes.size())];
    const std::size_t kinds = process.leaks ? kKinds.size() : kKinds.size() - 1;
    injections.push_back({.kind = kKinds[one_of(kinds)],
                          .process = process.name,
                          .at = plan.first + plan.apart * i + plan.within * random.uniform()});
  }
  return injections;
}

std::string faults_text(const std::vector<Injection>& injections, const InjectionPlan& plan) {
  std::string text;
  for (std::size_t i = 0; i < injections.size(); ++i) {
    const Injection& one = injections[i];
    const auto process = std::ranges::find(plan.processes, one.process, &InjectionPlan::Process::name);
    text += fmt::format("f{}: {{kind: {}, of: {}, from: {:.3f}s, for: 5s", i, one.kind, process->component,
                        one.at);
    if (one.kind == "process_leaks") text += ", parameters: {rate: 1000, most: 2000}";
    text += "}\n";
  }
  return text;
}

}  // namespace bw
