// What has long stood round the robot, learnt while it drives: a grid in O (odom) that rolls along with the
// scanner. Each cell counts the time for which beams ended in it; it loses time when beams go through, and
// keeps it while hidden. Near tracked people no cell gains time, so that who stands does not become
// furniture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/people/detector/beams.hpp"
#include "components/people/detector/detector_options.hpp"

namespace bw::people {

class LocalBackground {
 public:
  explicit LocalBackground(const BackgroundOptions& options);

  /// Learns from one sweep. `people`: positions in O that belong to tracked people. A clock that goes back or
  /// stands still changes nothing.
  void learn(const Beams& beams, Time time, std::span<const Vector2> people);

  /// Whether something has stood at `p_O`, or in a cell beside it, for `stood`.
  bool contains(const Vector2& p_O) const;

  void reset();

 private:
  static constexpr int kSide = 256;  ///< cells; a power of two

  struct Cell {
    int column = 0;  ///< of the whole plane: a slot serves all cells that are kSide apart
    int row = 0;
    float stood = 0.0F;       ///< [s]
    std::uint32_t sweep = 0;  ///< the last one that ended here
    bool listed = false;      ///< in active_
  };

  int to_cell(double coordinate) const;
  const Cell& slot(int column, int row) const { return cells_[slot_of(column, row)]; }
  static std::size_t slot_of(int column, int row);
  bool stood_long(int column, int row) const;
  void mark(const Beams& beams, float elapsed, std::span<const Vector2> people);
  void clear(const Beams& beams, float elapsed);

  BackgroundOptions options_;
  std::vector<Cell> cells_;
  std::vector<std::size_t> active_;  ///< slots that hold time
  std::uint32_t sweep_ = 0;
  Time last_;
};

}  // namespace bw::people
