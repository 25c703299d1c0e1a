// bandwagon bench teb|crowd: a planner on benchmark scenes, without DDS.
#pragma once

#include <CLI/App.hpp>

namespace bw {

void add_bench(CLI::App& app, int& status);

}  // namespace bw
