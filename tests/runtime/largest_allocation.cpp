#include "tests/runtime/largest_allocation.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace bw {

std::size_t largest_allocation = 0;

}  // namespace bw

void* operator new(std::size_t size) {
  bw::largest_allocation = std::max(bw::largest_allocation, size);
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
