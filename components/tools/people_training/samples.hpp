// Outlines with their truth, collected from rooms.
#pragma once

#include <cstdint>
#include <vector>

#include "components/people/detector/features.hpp"
#include "components/tools/people_training/labels.hpp"

namespace bw::people {

struct Sample {
  Features features;
  Kind kind = Kind::other;
};

struct Collection {
  std::uint64_t first_seed = 1;
  int rooms = 1;
  int sweeps = 120;  ///< of each room
  int every = 4;     ///< so many sweeps apart outlines are taken: neighbours are nearly alike
};

/// Outlines no wider than kWidestPerson whose kind is clear. The same seeds give the same samples.
std::vector<Sample> collect(const Collection& collection);

}  // namespace bw::people
