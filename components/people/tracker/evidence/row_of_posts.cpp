#include "components/people/tracker/evidence/row_of_posts.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

constexpr double kNearest = 0.28;  // [m] legs of somebody who stands are closer
constexpr double kFarthest = 1.7;  // [m] longest side of a table
constexpr double kSquare = 0.09;   // cosine of a corner, at most
constexpr double kAlike = 0.05;    // [m] by which positions and widths of furniture agree

bool alike(const Post& a, const Post& b) { return std::abs(a.width - b.width) <= kAlike; }

bool any_at(const Vector2& position, const Post& like, std::span<const Post> posts) {
  return std::ranges::any_of(
      posts, [&](const Post& p) { return (p.position - position).norm() <= kAlike && alike(p, like); });
}

}  // namespace

RowOfPosts row_of_posts(const Post& post, std::span<const Post> others) {
  RowOfPosts found;
  const auto side = [&](const Post& other) {
    const double length = (other.position - post.position).norm();
    return length >= kNearest && length <= kFarthest && alike(other, post);
  };
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (!side(others[i])) continue;
    const Vector2 a = others[i].position - post.position;
    if (any_at(post.position - a, post, others) || any_at(post.position + 2.0 * a, post, others))
      found.log_odds = std::min(found.log_odds, RowOfPosts::kRow);
    for (std::size_t j = i + 1; j < others.size(); ++j) {
      if (!side(others[j])) continue;
      const Vector2 b = others[j].position - post.position;
      if (std::abs(a.dot(b)) > kSquare * a.norm() * b.norm()) continue;
      const bool closed = any_at(post.position + a + b, post, others);
      found.log_odds = std::min(found.log_odds, closed ? RowOfPosts::kRectangle : RowOfPosts::kCorner);
    }
  }
  return found;
}

}  // namespace bw::people
