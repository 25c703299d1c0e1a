#include "components/lab/tune/successive_halving.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace bw::tune {

std::size_t candidates_for(std::size_t drives) {
  std::size_t best = 1;
  for (std::size_t count = 1;; ++count) {
    std::size_t needed = 0;
    std::size_t there = count;
    std::size_t before = 0;
    for (const std::size_t rung : kRungs) {
      needed += there * (rung - before);
      before = rung;
      there = (there + kKept - 1) / kKept + 1;  // and candidate 0
    }
    if (needed > drives) return best;
    best = count;
  }
}

std::vector<Candidate> successive_halving(std::size_t candidates, const Drive& drive) {
  std::vector<Candidate> all(candidates);
  for (std::size_t k = 0; k < candidates; ++k) all[k].number = k;
  std::vector<std::size_t> there(candidates);
  std::iota(there.begin(), there.end(), std::size_t{0});
  for (const std::size_t rung : kRungs) {
    for (const std::size_t k : there) {
      Candidate& one = all[k];
      const std::vector<double> costs = drive(k, one.episodes, rung - one.episodes);
      const double sum =
          std::accumulate(costs.begin(), costs.end(), one.cost * static_cast<double>(one.episodes));
      one.episodes = rung;
      one.cost = sum / static_cast<double>(rung);
    }
    std::ranges::sort(there, [&](std::size_t a, std::size_t b) {
      return std::tuple(all[a].cost, a) < std::tuple(all[b].cost, b);
    });
    there.resize((there.size() + kKept - 1) / kKept);
    if (std::ranges::find(there, std::size_t{0}) == there.end()) there.push_back(0);
  }
  std::ranges::sort(all, [](const Candidate& a, const Candidate& b) {
    return std::tuple(b.episodes, a.cost, a.number) < std::tuple(a.episodes, b.cost, b.number);
  });
  return all;
}

}  // namespace bw::tune
