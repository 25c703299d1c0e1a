// What was seen empty earlier and holds something now: furniture does not come, people do. Sweeps of the last
// 45 s are kept in S (the tracker's frame, which in that time drifts by 1 to 3 cm), with one sensor; with
// more of them for less time.
#pragma once

#include <vector>

#include "components/people/detection.hpp"

namespace bw::people {

class PastSweeps {
 public:
  enum class Past {
    unknown,
    empty,     ///< nothing stood there, twice on end, nor earlier
    occupied,  ///< something stood there all the time that it was in view
  };

  /// One sweep in S at `now` [s, from the tracker's own origin].
  void add(const DetectionSet& sweep, double now);

  /// What was at `position`. Only beams tell that would have shown something as thin as a leg; who has come
  /// within 2 s leaves it unknown or empty.
  Past at(const Vector2& position, double now) const;

  void reset();

 private:
  struct Sweep {
    int source = 0;
    double time = -1.0;  ///< < 0: none
    Vector2 sensor{0.0, 0.0};
    double angle_min = 0.0;
    double angle_increment = 0.0;
    std::vector<float> ranges;
  };
  static Past view_of(const Sweep& sweep, const Vector2& position);

  std::vector<Sweep> sweeps_;  ///< a ring
  std::size_t next_ = 0;
};

}  // namespace bw::people
