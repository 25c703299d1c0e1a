#include "components/people/score/gospa.hpp"

#include <cmath>

namespace bw::people {

double Gospa::operator()(const std::vector<Vector2>& truth, const std::vector<Vector2>& tracks) {
  const double one = std::pow(kCutoff, kPower) / 2.0;  // of who is missed, or of a false track
  assignment_.begin(tracks.size());
  for (const Vector2& person : truth) {
    assignment_.add_row(one);
    for (std::size_t j = 0; j < tracks.size(); ++j) {
      const double distance = (tracks[j] - person).norm();
      // Less by the track that is then not false.
      if (distance < kCutoff) assignment_.allow(j, std::pow(distance, kPower) - one);
    }
  }
  assignment_.solve();
  return std::pow(assignment_.total() + one * static_cast<double>(tracks.size()), 1.0 / kPower);
}

}  // namespace bw::people
