// What the two programs have in common: a command line of verbs, and exceptions as exit statuses.
#pragma once

#include <string>

namespace bw {

/// Runs the verb that the command line names, of all that are linked in. Exit status: 0 done, 1 the job
/// failed, 2 wrong use or configuration.
int run_program(const std::string& name, const std::string& help, int argc, char** argv);

}  // namespace bw
