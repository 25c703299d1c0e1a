// What `bandwagon run` is told, and `bandwagon launch` tells each process of a graph.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "components/program/page_options.hpp"
#include "components/program/record_options.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/graph/graph.hpp"

namespace bw {

struct RunOptions {
  std::string graph;
  std::string clock = "wall";
  std::uint64_t seed = 1;
  std::vector<std::string> set;
  bool emulate = false;
  std::string only;
  double for_s = 0.0;
  std::optional<double> pace;
  bool stay = false;
  std::string json;
  std::string svg;
  std::string html;
  RecordOptions record;
  PageOptions page;
  bool progress = false;
  bool fail_on_contact = false;
  bool accept_inputs = false;

  /// The graph as these options make it. Throws ConfigError or std::runtime_error.
  [[nodiscard]] Graph load() const;
};

void add_run_options(cli::Verb verb, const std::shared_ptr<RunOptions>& options);

}  // namespace bw
