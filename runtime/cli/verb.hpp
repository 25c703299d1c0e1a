// Verbs of the program `bandwagon`. One joins by a line in its own source file,
//
//   CLI::App* add_list(CLI::App& app, int& status) { return app.add_subcommand("list", "...")->callback(...); }
//   BW_VERB(look, "list", add_list)
//
// and by `bw_verb(list SOURCES list.cpp)` in its CMakeLists.txt. Exit status of every verb: 0 done, 1 the job
// failed, 2 wrong use or configuration (ConfigError or std::runtime_error while configuring).
#pragma once

#include <string_view>

#include <CLI/App.hpp>

namespace bw::cli {

/// Headings of `bandwagon --help`, in their order.
enum class VerbGroup { drive, look, measure };

/// Adds the verb to the program; its callback sets `status` when it does not end in 0. Returns what it added.
using AddVerb = CLI::App* (*)(CLI::App& app, int& status);

/// Throws std::logic_error when the name is taken.
bool register_verb(VerbGroup group, std::string_view name, AddVerb add);

/// All registered verbs, by group and name.
void add_verbs(CLI::App& app, int& status);

}  // namespace bw::cli

/// Once per verb, in its source file.
#define BW_VERB(group, name, add)                                                                            \
  namespace {                                                                                                \
  [[maybe_unused]] const bool verb_##add = ::bw::cli::register_verb(::bw::cli::VerbGroup::group, name, add); \
  }
