// How many parameters can be turned: `bandwagon param list --all --count GRAPH...`.
#pragma once

#include <string>
#include <vector>

namespace bw::cli {

/// A name is the type of a component, or the section that components share, and the dotted path below it; it
/// counts once, however many instances and graphs have it, and so does each field of a list of structs, be
/// the list empty. What the graphs leave out (`enabled: false`) counts too. Prints each type with its number,
/// then their sum. Without `all` those alone that people turn first. Returns the exit status: 1 when a type
/// of component would not be configured in any of the graphs.
int count_names(const std::vector<std::string>& graphs, const std::vector<std::string>& set, bool all);

}  // namespace bw::cli
