// bandwagon evaluate SUITE: drives every episode of a suite with every seed and planner, in lock-step, and
// sums up. Exit status 0 when all ran (and --at-least held), 1 when not, 2 on a wrong configuration.
#pragma once

#include <CLI/App.hpp>

namespace bw {

void add_evaluate(CLI::App& app, int& status);

}  // namespace bw
