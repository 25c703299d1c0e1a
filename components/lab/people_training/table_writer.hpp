// Boosted trees as the C++ table that the program reads.
#pragma once

#include <iosfwd>
#include <string>

#include "components/lab/people_training/boosting.hpp"

namespace bw::people {

/// `value` with five digits, as a literal of C++: 0.5, 3., 1e-05.
std::string literal(double value);

/// The constants k<name>Bias and k<name>Trees.
void write_trees(std::ostream& out, const std::string& name, const BoostedTrees& boosted);

}  // namespace bw::people
