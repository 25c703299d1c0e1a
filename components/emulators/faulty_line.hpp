// What becomes of bytes on their way from the board to the host while something is wrong.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/emulators/faults.hpp"
#include "components/model/random.hpp"

namespace bw::emulators {

class FaultyLine {
 public:
  explicit FaultyLine(std::uint64_t seed) : random_(seed) {}

  /// `bytes`: sent at a time; valid until the next call.
  std::span<const std::uint8_t> pass(std::span<const std::uint8_t> bytes, const Faults& faults);

 private:
  Random random_;
  std::vector<std::uint8_t> passed_;
};

}  // namespace bw::emulators
