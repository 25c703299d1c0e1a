// Outlines with their truth, collected from rooms.
#pragma once

#include <cstdint>
#include <vector>

#include "components/lab/people_training/labels.hpp"
#include "components/people/detector/features.hpp"

namespace bw::people {

struct Sample {
  Features features;
  Kind kind = Kind::other;
  Piece piece = Piece::wall;  ///< of the kind other
};

struct Collection {
  std::uint64_t first_seed = 1;
  int rooms = 1;
  double seconds = 12.0;  ///< of each room
  double every = 0.4;     ///< so long apart outlines are taken: neighbours are nearly alike [s]
};

/// Outlines no wider than kWidestPerson whose kind is clear, of walls a third. The same seeds give the same
/// samples.
std::vector<Sample> collect(const Collection& collection);

}  // namespace bw::people
