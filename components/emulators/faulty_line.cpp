#include "components/emulators/faulty_line.hpp"

#include <cstddef>

namespace bw::emulators {

std::span<const std::uint8_t> FaultyLine::pass(std::span<const std::uint8_t> bytes, const Faults& faults) {
  passed_.assign(bytes.begin(), bytes.end());
  if (faults.cable_pulled || faults.silent || faults.hung) passed_.clear();
  if (faults.half_frames) passed_.resize(passed_.size() / 2);
  if (passed_.empty()) return passed_;
  if (faults.garbage) {
    for (std::uint8_t& byte : passed_) byte = static_cast<std::uint8_t>(random_.bits());
  }
  if (faults.corrupt) {
    const std::uint64_t bit = random_.bits() % (passed_.size() * 8);
    passed_[static_cast<std::size_t>(bit / 8)] ^= static_cast<std::uint8_t>(1U << (bit % 8));
  }
  return passed_;
}

}  // namespace bw::emulators
