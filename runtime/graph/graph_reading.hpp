// What reading a graph's file, its sections and changes of it by a command line share.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/read_parameters.hpp"

namespace bw {

/// Sections that components read parameters of.
inline constexpr std::array<std::string_view, 2> kSharedSections = {"robot", "faults"};

inline bool is_shared_section(std::string_view name) {
  return std::ranges::find(kSharedSections, name) != kSharedSections.end();
}

/// By its own name, or by that of all robots' nodes.
inline bool is_meant(const ComponentNode& node, const std::string& name) {
  return node.name == name || (!node.robot.empty() && node.node_name() == name);
}

inline bool is_emulate(const Override& change) { return change.path == std::vector<std::string>{"emulate"}; }

/// Of processes, lanes and types: nothing, or what a name must be.
std::optional<std::string> label_rule(std::string_view name);

/// A text of `map`, the reader's, that must also keep a rule, which says nothing where it is kept.
void read_name(ParameterReader& reader, const ConfigNode& map, std::string_view name, std::string& value,
               std::optional<std::string> (*rule)(std::string_view));

/// A duration within limits; `example` is for who wrote another. Nothing where it is not given, or refused.
std::optional<Duration> read_span(ParameterReader& reader, std::string_view name, Duration least,
                                  Duration most, std::string_view example);

}  // namespace bw
