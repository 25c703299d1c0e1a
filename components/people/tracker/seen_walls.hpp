// What was seen to stand lately, as far as people cannot walk through it: a grid in S (the tracker's frame)
// that takes no more memory however far the robot drives. Near people nothing is remembered, that who stands
// does not become a wall.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/people/detection.hpp"

namespace bw::people {

class SeenWalls {
 public:
  SeenWalls();

  /// One sweep in S at `now` [s, from the tracker's own origin], with the positions of people.
  void add(const DetectionSet& sweep, double now, std::span<const Vector2> people);

  /// Whether beams ended here for a second on end, half a minute ago at most.
  bool contains(const Vector2& p_S) const;

  void reset();

 private:
  static constexpr std::int32_t kSide = 256;  ///< cells; a power of two

  struct Cell {
    std::int32_t column = 0;  ///< of the whole plane: a slot serves all cells that are kSide apart
    std::int32_t row = 0;
    float since = 0.0F;  ///< beams have ended here since then without a pause [s]
    float last = -1e9F;  ///< the last of them [s]
  };

  static std::int32_t to_cell(double coordinate);
  static std::size_t slot_of(std::int32_t column, std::int32_t row);
  void mark(const Vector2& p_S);

  std::vector<Cell> cells_;
  float now_ = 0.0F;
};

}  // namespace bw::people
