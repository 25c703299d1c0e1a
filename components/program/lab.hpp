// Verbs of the program `bandwagon-lab`, which no robot needs: `bandwagon` lists them, and starts that program
// with them.
#pragma once

#include <span>

namespace bw {

/// Whether the verb that `arguments` begin with, behind the program's name, is one of them.
bool is_for_lab(std::span<const char* const> arguments);

/// Goes on as that program, beside this one, with the same arguments. Returns only where it is not there:
/// says how to get it, and returns the exit status.
int become_lab(char** arguments);

}  // namespace bw
