// bandwagon failsafes GRAPH: what makes the robot of this graph slow down or stop, and how it drives again.
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "runtime/cli/emulate_option.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/host/host.hpp"

namespace bw::cli {
namespace {

struct FailsafesOptions {
  std::string path;
  std::vector<std::string> set;
  bool emulate = false;
};

void show_failsafes(const FailsafesOptions& options) {
  const Host host(load_graph(options.path, with_emulation(options.set, options.emulate)), {});
  constexpr const char* kLine = "{:20} {:18} {:>8}  {:14} {}; {}\n";
  std::cout << fmt::format(kLine, "component", "failsafe", "after", "action", "when", "drives again");
  for (const auto& [component, row] : host.failsafes())
    std::cout << fmt::format(
        kLine, component, row.name,
        row.debounce == Duration{} ? "at once" : fmt::format("{:g} s", row.debounce.to_seconds()),
        text_of(row.action), row.condition, row.recovery);
}

void add_failsafes(Verb verb) {
  auto options = std::make_shared<FailsafesOptions>();
  verb.option("GRAPH", options->path, "Graph file").required();
  verb.option("--set", options->set, "component.param=value").one_each_time();
  verb.flag("--emulate", options->emulate, kEmulateHelp);
  verb.run([options] { show_failsafes(*options); });
}

}  // namespace

BW_VERB(look, "failsafes", "What makes the robot of a graph slow down or stop, and how it drives again",
        add_failsafes)

}  // namespace bw::cli
