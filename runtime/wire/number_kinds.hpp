// What a number of a message may be, and its bytes.
#pragma once

#include <optional>
#include <string>

#include "runtime/wire/cdr_writer.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw {

/// The rule that a field of this kind holds and the value breaks: a whole number in range, a float32 that is
/// not too large.
std::optional<std::string> broken_rule(Kind kind, double value);

/// Of a value that breaks no rule.
void write_number(Kind kind, double value, CdrWriter& writer);

}  // namespace bw
