// bandwagon run GRAPH: drives a graph to its end and reports. Exit status 0 when the goal was reached (or the
// time given is over in a graph without a score card), 1 when not, 2 on a wrong configuration.
#pragma once

#include <CLI/App.hpp>

namespace bw {

void add_run(CLI::App& app, int& status);

}  // namespace bw
