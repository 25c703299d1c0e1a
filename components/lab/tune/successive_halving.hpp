// The best of many candidates for a number of drives that was fixed before (Karnin, Koren and Somekh 2013; Jamieson and
// Talwalkar 2016): all drive a few episodes, the best third of them some more, and so on. All drive the same episodes.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace bw::tune {

/// Episodes that those who are still there have driven at the end of each rung; a third goes on.
inline constexpr std::size_t kRungs[] = {6, 18, 54, 162};
inline constexpr std::size_t kKept = 3;  ///< one of so many goes on

/// How many candidates `drives` drives are enough for. At least 1.
std::size_t candidates_for(std::size_t drives);

struct Candidate {
  std::size_t number = 0;
  std::size_t episodes = 0;
  double cost = 0.0;  ///< mean of its episodes
};

/// Cost of each of a candidate's `first` to `first + count - 1`-th episodes.
using Drive = std::function<std::vector<double>(std::size_t candidate, std::size_t first, std::size_t count)>;

/// Best first: by how far they came, then by cost, then by number. Candidate 0, where they begin, drives all rungs.
std::vector<Candidate> successive_halving(std::size_t candidates, const Drive& drive);

}  // namespace bw::tune
