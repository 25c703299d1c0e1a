#include "components/program/lab.hpp"

#include <filesystem>
#include <iostream>
#include <string_view>

#include <unistd.h>

#include "runtime/cli/verb.hpp"
#include "runtime/parameters/own_program.hpp"

namespace bw {
namespace {

constexpr const char* kProgram = "bandwagon-lab";

// --help lists them.
[[maybe_unused]] const bool is_listed =
    cli::register_verb(cli::VerbGroup::measure, "evaluate",
                       "Of bandwagon-lab: drives suites of episodes in lock-step and sums up",
                       [](cli::Verb) {}) &&
    cli::register_verb(
        cli::VerbGroup::measure, "bench",
        "Of bandwagon-lab: planners on benchmark scenes; recordings: speed, people tracked in them, SLAM",
        [](cli::Verb) {}) &&
    cli::register_verb(cli::VerbGroup::measure, "reproduce",
                       "Of bandwagon-lab: a table or figure of the dissertation again", [](cli::Verb) {}) &&
    cli::register_verb(cli::VerbGroup::measure, "figures",
                       "Of bandwagon-lab: draws the figures of the theory pages anew", [](cli::Verb) {});

}  // namespace

bool is_for_lab(std::span<const char* const> arguments) {
  if (arguments.size() > 2 && std::string_view(arguments[1]) == "complete")
    return arguments.size() > 3 && is_for_lab(arguments.subspan(1));
  const auto is = [&](std::size_t i, std::string_view word) {
    return i < arguments.size() && word == arguments[i];
  };
  return is(1, "evaluate") || is(1, "bench") || is(1, "reproduce") || is(1, "figures") ||
         (is(1, "bag") && is(2, "import"));
}

int become_lab(char** arguments) {
  const auto program = own_program().parent_path() / kProgram;
  execv(program.c_str(), arguments);
  std::cerr << "`" << arguments[1] << "` is of the program " << kProgram << ", which is not at "
            << program.string() << ": launch_scripts/build.sh release lab builds it\n";
  return 2;
}

}  // namespace bw
