// What a shell may complete: values that options and positionals take, by the name that the command line gives them.
#pragma once

#include <string>
#include <vector>

namespace bw::cli {

/// `asked`: --set, --planner, GRAPH, SUITE, and so on; `words`: the command line before it, behind the
/// program's name; `begun`: what stands there of it. Graphs, robots and suites by name, parameters of the graph
/// that the words name, their values where they are few. Nothing where files are meant, or nothing is known.
std::vector<std::string> value_candidates(const std::string& asked, const std::vector<std::string>& words,
                                          const std::string& begun);

}  // namespace bw::cli
