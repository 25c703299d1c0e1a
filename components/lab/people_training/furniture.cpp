#include "components/lab/people_training/furniture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace bw::people {
namespace {

/// Of `least` to `most`, both included.
int count_between(Random& random, int least, int most) {
  return least + static_cast<int>(random.uniform() * (most - least + 1));
}

double distance_to(const Segment& segment, const Vector2& p) {
  const Vector2 along = segment.b - segment.a;
  const double length = along.squaredNorm();
  const double share = length > 0.0 ? std::clamp((p - segment.a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (p - segment.a - share * along).norm();
}

}  // namespace

const char* name_of(Piece piece) {
  constexpr std::array<const char*, kPieces> kNames = {"wall",  "box",   "pillar", "post",   "chair",
                                                       "table", "shelf", "plant",  "trolley"};
  return kNames[static_cast<std::size_t>(piece)];
}

void Furniture::add(Piece piece, const Pose2& X_MP, Random& random) {
  switch (piece) {
    case Piece::wall:
      return add_segment(piece, {X_MP.position(), X_MP * Vector2(random.uniform(0.5, 3.0), 0.0)});
    case Piece::box: {
      const double length = random.uniform(0.15, 1.2);
      return add_box(piece, X_MP, length, random.uniform(0.15, 0.8));
    }
    case Piece::pillar:
      return add_disc(piece, X_MP.position(), random.uniform(0.1, 0.3));
    case Piece::post:
      return add_post(X_MP, random);
    case Piece::chair:
      return add_chair(X_MP, random);
    case Piece::table:
      return add_table(X_MP, random);
    case Piece::shelf:
      return add_shelf(X_MP, random);
    case Piece::plant:
      return add_plant(X_MP, random);
    case Piece::trolley:
      return add_trolley(X_MP, random);
    case Piece::count:
      return;
  }
}

void Furniture::add_segment(Piece piece, const Segment& segment) {
  shapes_.segments.push_back(segment);
  of_segment_.push_back(piece);
}

void Furniture::add_disc(Piece piece, const Vector2& center, double radius) {
  shapes_.discs.push_back({center, radius});
  of_disc_.push_back(piece);
}

void Furniture::add_box(Piece piece, const Pose2& X_MP, double length, double width) {
  const std::array<Vector2, 4> corners = {
      X_MP * Vector2(length / 2, width / 2), X_MP * Vector2(-length / 2, width / 2),
      X_MP * Vector2(-length / 2, -width / 2), X_MP * Vector2(length / 2, -width / 2)};
  for (std::size_t i = 0; i < 4; ++i) add_segment(piece, {corners[i], corners[(i + 1) % 4]});
}

void Furniture::add_four_discs(Piece piece, const Pose2& X_MP, double length, double width, double radius) {
  for (const double x : {-length / 2, length / 2})
    for (const double y : {-width / 2, width / 2}) add_disc(piece, X_MP * Vector2(x, y), radius);
}

void Furniture::add_post(const Pose2& X_MP, Random& random) {
  const double across = random.uniform(0.02, 0.2);
  if (random.uniform() < 0.25) return add_box(Piece::post, X_MP, across, across);
  add_disc(Piece::post, X_MP.position(), across / 2);
}

void Furniture::add_chair(const Pose2& X_MP, Random& random) {
  if (random.uniform() < 0.75) {
    const double side = random.uniform(0.33, 0.5);
    const double depth = side * random.uniform(0.85, 1.15);
    return add_four_discs(Piece::chair, X_MP, side, depth, random.uniform(0.01, 0.03));
  }
  add_disc(Piece::chair, X_MP.position(), random.uniform(0.025, 0.045));
  if (random.uniform() < 0.5) return;  // above the castors
  const double reach = random.uniform(0.25, 0.33);
  for (int arm = 0; arm < 5; ++arm)
    add_disc(Piece::chair, X_MP * (reach * direction(2.0 * std::numbers::pi * arm / 5)), 0.03);
}

void Furniture::add_table(const Pose2& X_MP, Random& random) {
  if (random.uniform() < 0.2) return add_disc(Piece::table, X_MP.position(), random.uniform(0.03, 0.09));
  const double length = random.uniform(0.7, 1.8);
  const double width = random.uniform(0.6, 0.9);
  const double leg = random.uniform(0.015, 0.05);
  if (random.uniform() < 0.6) return add_four_discs(Piece::table, X_MP, length, width, leg);
  for (const double x : {-length / 2, length / 2})
    for (const double y : {-width / 2, width / 2})
      add_box(Piece::table, X_MP * Pose2{x, y, 0.0}, 2 * leg, 2 * leg);
}

void Furniture::add_shelf(const Pose2& X_MP, Random& random) {
  const int bays = count_between(random, 1, 3);
  const double bay = random.uniform(0.5, 1.1);
  const double depth = random.uniform(0.3, 0.5);
  const double upright = random.uniform(0.02, 0.05);
  for (int i = 0; i <= bays; ++i) {
    const double x = bay * (i - bays / 2.0);
    for (const double y : {-depth / 2, depth / 2})
      add_box(Piece::shelf, X_MP * Pose2{x, y, 0.0}, upright, upright);
    if (i == bays || random.uniform() < 0.5) continue;  // nothing stands in this bay
    const double length = bay * random.uniform(0.3, 0.8);
    add_box(Piece::shelf, X_MP * Pose2{x + bay / 2, 0.0, 0.0}, length, depth * 0.7);
  }
}

void Furniture::add_plant(const Pose2& X_MP, Random& random) {
  if (random.uniform() < 0.5) return add_disc(Piece::plant, X_MP.position(), random.uniform(0.07, 0.2));
  const double reach = random.uniform(0.1, 0.3);
  for (int n = count_between(random, 3, 12); n > 0; --n) {
    const double away = reach * std::sqrt(random.uniform());
    const double bearing = random.uniform(-std::numbers::pi, std::numbers::pi);
    add_disc(Piece::plant, X_MP * (away * direction(bearing)), random.uniform(0.004, 0.03));
  }
}

void Furniture::add_trolley(const Pose2& X_MP, Random& random) {
  const double length = random.uniform(0.5, 1.0);
  const double width = random.uniform(0.4, 0.6);
  add_four_discs(Piece::trolley, X_MP, length, width, random.uniform(0.012, 0.05));
  if (random.uniform() < 0.4) add_box(Piece::trolley, X_MP, length * 0.8, width * 0.8);
}

void Furniture::add_dining_table(const Pose2& X_MP, Random& random) {
  add(Piece::table, X_MP, random);
  constexpr std::array<double, 4> kSides = {0.0, 0.5, 1.0, 1.5};
  for (const double side : kSides) {
    if (random.uniform() < 0.3) continue;
    const double bearing = side * std::numbers::pi + random.uniform(-0.2, 0.2);
    const Vector2 position = random.uniform(0.65, 1.05) * direction(bearing);
    add(Piece::chair, X_MP * Pose2{position.x(), position.y(), bearing + random.uniform(-0.4, 0.4)}, random);
  }
}

Piece Furniture::nearest(const Vector2& p_M) const {
  double least = std::numeric_limits<double>::infinity();
  Piece piece = Piece::wall;
  const auto offer = [&](double distance, Piece of) {
    if (distance >= least) return;
    least = distance;
    piece = of;
  };
  for (std::size_t i = 0; i < shapes_.discs.size(); ++i)
    offer(std::abs((p_M - shapes_.discs[i].center).norm() - shapes_.discs[i].radius), of_disc_[i]);
  for (std::size_t i = 0; i < shapes_.segments.size(); ++i)
    offer(distance_to(shapes_.segments[i], p_M), of_segment_[i]);
  return piece;
}

}  // namespace bw::people
