// `bandwagon bench corridor`, `dynabarn` and `flows`: their options.
#pragma once

#include "runtime/cli/verb.hpp"

namespace bw {

void add_corridor(cli::Verb bench);
void add_dynabarn(cli::Verb bench);
void add_flows(cli::Verb bench);

}  // namespace bw
