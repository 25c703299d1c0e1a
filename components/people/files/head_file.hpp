// Weights of the learned prediction head as text. Line 1 names the format; line 2 is `hash` and the FNV-1a hash (64 bits, 16
// hexadecimal digits) of all that follows; line 3 is `sizes`: inputs, hidden layers, outputs. Then the means and the deviations
// of the inputs, a line each, and for each layer a line for each output: its weights and, last, its offset.
#pragma once

#include <iosfwd>
#include <string>

#include "components/people/prediction/learned_head.hpp"

namespace bw::people {

/// Throws std::runtime_error naming file, line and rule: another format or hash, sizes that do not fit the head, more than
/// 100000 numbers, numbers that are not finite, deviations not above 0.
HeadWeights read_head(std::istream& input, const std::string& file);
HeadWeights read_head(const std::string& file);

/// The same bytes for the same weights; five digits.
void write_head(std::ostream& out, const HeadWeights& weights);

}  // namespace bw::people
