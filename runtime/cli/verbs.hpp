// The verbs of `bandwagon` that know no robot. Each adds itself to the command line; its action returns
// through `status` what scripts see: 0 ok, 1 the job failed, 2 wrong use or configuration (thrown as
// ConfigError or std::runtime_error while configuring).
#pragma once

#include <CLI/App.hpp>

namespace bw::cli {

void add_list(CLI::App& app, int& status);    ///< list: component types
void add_graph(CLI::App& app, int& status);   ///< graph FILE [--dot]
void add_param(CLI::App& app, int& status);   ///< param list|dump
void add_topic(CLI::App& app, int& status);   ///< topic list|info|echo|hz
void add_node(CLI::App& app, int& status);    ///< node list
void add_doctor(CLI::App& app, int& status);  ///< doctor

}  // namespace bw::cli
