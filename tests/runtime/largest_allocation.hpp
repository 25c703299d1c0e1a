// The largest single allocation of the program so far, in bytes; a test may set it back. Link
// largest_allocation.cpp, which replaces operator new.
#pragma once

#include <cstddef>

namespace bw {

extern std::size_t largest_allocation;

}  // namespace bw
