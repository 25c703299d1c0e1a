// Furniture as a laser 0.1 to 0.5 m above the floor cuts it: discs and segments, much of which looks like
// legs. Frame M: the room [m].
#pragma once

#include <cstdint>
#include <vector>

#include "components/model/obstacles.hpp"
#include "components/model/random.hpp"

namespace bw::people {

enum class Piece : std::uint8_t {
  wall,
  box,      ///< cupboards, crates
  pillar,   ///< round, 0.2 to 0.6 m across: pillars, pots, bins
  post,     ///< round or square, 0.02 to 0.2 m across
  chair,    ///< four legs, or a column on five arms
  table,    ///< four legs, or a column
  shelf,    ///< uprights in two rows, things on the lowest board
  plant,    ///< a pot, or stems and leaves
  trolley,  ///< four tubes or wheels, with or without a tray between them
  count
};
inline constexpr std::size_t kPieces = static_cast<std::size_t>(Piece::count);
const char* name_of(Piece piece);

/// All that stands in a room, each shape with the piece it belongs to.
class Furniture {
 public:
  /// Draws one piece round X_MP; how large it is and of which make comes from `random`.
  void add(Piece piece, const Pose2& X_MP, Random& random);
  void add_box(Piece piece, const Pose2& X_MP, double length, double width);
  void add_segment(Piece piece, const Segment& segment);

  /// A table with chairs pushed up to it or drawn back, as many as four.
  void add_dining_table(const Pose2& X_MP, Random& random);

  const StaticObstacles& shapes() const { return shapes_; }
  /// The piece whose surface is nearest to `p_M`; wall when there is none.
  Piece nearest(const Vector2& p_M) const;

 private:
  void add_disc(Piece piece, const Vector2& center, double radius);
  void add_four_discs(Piece piece, const Pose2& X_MP, double length, double width, double radius);
  void add_post(const Pose2& X_MP, Random& random);
  void add_chair(const Pose2& X_MP, Random& random);
  void add_table(const Pose2& X_MP, Random& random);
  void add_shelf(const Pose2& X_MP, Random& random);
  void add_plant(const Pose2& X_MP, Random& random);
  void add_trolley(const Pose2& X_MP, Random& random);

  StaticObstacles shapes_;
  std::vector<Piece> of_disc_;
  std::vector<Piece> of_segment_;
};

}  // namespace bw::people
