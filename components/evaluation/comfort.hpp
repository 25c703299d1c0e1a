// How near a robot is to people at one instant. Values in, result out.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "components/evaluation/truth_sample.hpp"
#include "components/model/footprint.hpp"

namespace bw {

struct Comfort {
  double closest_person =
      std::numeric_limits<double>::infinity();  ///< boundary to boundary [m]; negative: overlapping
  std::uint32_t closest_person_id = 0;          ///< 0: nobody is there
  double collision_index = 0.0;                 ///< theory.md 7.7, of the sigma that judges
};

/// Nothing for a sample with a position that is not finite.
std::optional<Comfort> comfort_of(const TruthSample& sample, const Footprint& robot);

}  // namespace bw
