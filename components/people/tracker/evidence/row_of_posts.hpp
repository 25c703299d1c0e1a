// Furniture stands in pairs and rows: equal thin things at the corners of a rectangle, or one after the other
// at equal distances. Legs of people do not.
#pragma once

#include <span>

#include "runtime/base/pose2.hpp"

namespace bw::people {

/// Something thin that stands.
struct Post {
  Vector2 position{0.0, 0.0};
  double width = 0.0;  ///< [m]
};

struct RowOfPosts {
  static constexpr double kCorner = -1.0;     ///< log odds of a person with a third corner of a rectangle
  static constexpr double kRectangle = -3.0;  ///< with all four
  static constexpr double kRow = -2.0;        ///< of three at equal distances

  double log_odds = 0.0;
};

/// Of `post` among `others`, itself not among them: the strongest pattern that it is a part of.
RowOfPosts row_of_posts(const Post& post, std::span<const Post> others);

}  // namespace bw::people
