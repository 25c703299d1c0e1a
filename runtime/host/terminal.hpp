// Lines for the person at the terminal, on stderr, whose first letter is the level.
#pragma once

#include <string>

#include "runtime/logger.hpp"

namespace bw {

/// From any thread.
void write_to_terminal(LogLevel level, const std::string& text);

}  // namespace bw
