#include "components/model/footprint_outline.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace bw {
namespace {

constexpr double kSame = 1e-6;      // [m]: nearer corners are one, flatter ones none
constexpr double kThinnest = 1e-3;  // [m] from base_link to every side

double signed_area(const std::vector<Vector2>& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += 0.5 * cross(corners[i], corners[(i + 1) % corners.size()]);
  return area;
}

/// Of `p` from the line through a and b, positive on its left.
double left_of(const Vector2& a, const Vector2& b, const Vector2& p) {
  return cross(b - a, p - a) / std::max((b - a).norm(), 1e-12);
}

/// Corners that the outline does without.
void drop_idle(std::vector<Vector2>& corners) {
  for (std::size_t i = 0; corners.size() > 2 && i < corners.size();) {
    const std::size_t n = corners.size();
    const Vector2& before = corners[(i + n - 1) % n];
    const Vector2& after = corners[(i + 1) % n];
    const bool is_within = std::abs(left_of(before, after, corners[i])) < kSame &&
                           (corners[i] - before).dot(after - corners[i]) > 0.0;
    if (is_within || (corners[i] - before).norm() < kSame) {
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    } else {
      ++i;
    }
  }
}

/// One sentence; empty: a counter-clockwise convex polygon around base_link.
std::string fault_of_orientation(const std::vector<Vector2>& corners) {
  double angle = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2& a = corners[i];
    const Vector2& b = corners[(i + 1) % corners.size()];
    const Vector2& c = corners[(i + 2) % corners.size()];
    if (left_of(a, b, c) <= 0.0) return "must be convex: the outline turns inwards at a corner";
    angle += std::atan2(cross(a, b), a.dot(b));
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (left_of(corners[i], corners[(i + 1) % corners.size()], {0.0, 0.0}) < kThinnest)
      return "must have base_link, [0, 0], inside and 1 mm from every side at least";
  }
  if (angle > 3.0 * std::numbers::pi) return "must be convex: the outline crosses itself";
  return {};
}

Footprint enclosed(std::vector<Vector2> corners) {
  double radius = 0.0;
  for (const Vector2& corner : corners) radius = std::max(radius, corner.norm());
  return {radius, std::move(corners)};
}

/// Reads "[[x, y], ...]"; the commas may be missing, as in Nav2's own reader.
class CornerText {
 public:
  explicit CornerText(std::string_view text) : rest_(text) {}

  std::optional<std::vector<Vector2>> read() {
    std::vector<Vector2> corners;
    if (!take('[')) return std::nullopt;
    while (!take(']')) {
      Vector2 corner;
      if (!take('[') || !number(corner.x()) || !number(corner.y()) || !take(']')) return std::nullopt;
      if (corners.size() <= kMaxCorners) corners.push_back(corner);
    }
    skip();
    return rest_.empty() ? std::optional(std::move(corners)) : std::nullopt;
  }

 private:
  void skip() {
    const std::size_t at = rest_.find_first_not_of(" \t\r\n,");
    rest_.remove_prefix(std::min(at, rest_.size()));
  }
  bool take(char wanted) {
    skip();
    if (rest_.empty() || rest_.front() != wanted) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool number(double& value) {
    skip();
    if (rest_.starts_with('+')) rest_.remove_prefix(1);
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) return false;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return true;
  }

  std::string_view rest_;
};

/// What of a convex polygon lies on the left of the line through a and b moved to its right by `distance`.
std::vector<Vector2> cut(const std::vector<Vector2>& corners, const Vector2& a, const Vector2& b,
                         double distance) {
  std::vector<Vector2> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2& p = corners[i];
    const Vector2& q = corners[(i + 1) % corners.size()];
    const double at_p = left_of(a, b, p) + distance;
    const double at_q = left_of(a, b, q) + distance;
    if (at_p >= 0.0) kept.push_back(p);
    if ((at_p < 0.0) != (at_q < 0.0)) kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
  }
  return kept;
}

/// Of a disc, the corners of a polygon that holds it.
std::vector<Vector2> corners_around(const Footprint& footprint) {
  constexpr int kSides = 32;
  if (footprint.is_polygon()) return footprint.polygon;
  return outline({footprint.radius / std::cos(std::numbers::pi / kSides), {}}, {}, kSides);
}

/// Whether all of `inner` lies in `outer`, or within 1 um of it.
bool holds(const Footprint& outer, const Footprint& inner) {
  if (!outer.is_polygon()) return inner.radius <= outer.radius + kSame;
  const std::vector<Vector2>& sides = outer.polygon;
  const double around = inner.is_polygon() ? 0.0 : inner.radius;
  const std::vector<Vector2> points = inner.is_polygon() ? inner.polygon : std::vector<Vector2>{{0.0, 0.0}};
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (const Vector2& point : points)
      if (left_of(sides[i], sides[(i + 1) % sides.size()], point) < around - kSame) return false;
  return true;
}

}  // namespace

FootprintResult footprint_of(std::vector<Vector2> corners) {
  FootprintResult result;
  if (corners.size() > kMaxCorners) {
    result.fault = "must have 64 corners at most";
    return result;
  }
  for (const Vector2& corner : corners) {
    if (!corner.allFinite())
      result.fault = "must have finite numbers";
    else if (corner.norm() > kFarthestCorner)
      result.fault = "must have no corner farther than 5 m from base_link";
    if (!result.fault.empty()) return result;
  }
  if (signed_area(corners) < 0.0) std::reverse(corners.begin(), corners.end());
  drop_idle(corners);
  result.fault = corners.size() < 3 ? "must have three corners at least that are not on one line"
                                    : fault_of_orientation(corners);
  if (result.fault.empty()) result.footprint = enclosed(std::move(corners));
  return result;
}

FootprintResult footprint_of(std::string_view text, double radius) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return {{radius, {}}, {}};
  std::optional<std::vector<Vector2>> corners = CornerText(text).read();
  if (!corners) return {{}, "must be a list of corners [m] in base_link, as [[x, y], [x, y], [x, y]]"};
  if (corners->empty()) return {{radius, {}}, {}};
  return footprint_of(std::move(*corners));
}

std::string to_text(const Footprint& footprint) {
  std::string text = "[";
  const auto add = [&text](double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
    text.append(digits, end);
  };
  for (const Vector2& corner : footprint.polygon) {
    text.append(text.size() > 1 ? ", [" : "[");
    add(corner.x());
    text.append(", ");
    add(corner.y());
    text.append("]");
  }
  return text + "]";
}

Footprint padded(const Footprint& footprint, double distance) {
  if (distance == 0.0) return footprint;
  distance = std::max(distance, -0.5 * inscribed_radius(footprint));
  if (!footprint.is_polygon()) return {footprint.radius + distance, {}};
  // Twice as far out as any corner of the result.
  const double far = 1e3 * (footprint.radius + std::abs(distance));
  std::vector<Vector2> corners = {{-far, -far}, {far, -far}, {far, far}, {-far, far}};
  const std::vector<Vector2>& sides = footprint.polygon;
  for (std::size_t i = 0; i < sides.size(); ++i)
    corners = cut(corners, sides[i], sides[(i + 1) % sides.size()], distance);
  drop_idle(corners);
  return enclosed(std::move(corners));
}

Footprint hull(const Footprint& a, const Footprint& b) {
  if (!a.is_polygon() && !b.is_polygon()) return a.radius >= b.radius ? a : b;
  if (holds(a, b)) return a;
  if (holds(b, a)) return b;
  std::vector<Vector2> points = corners_around(a);
  const std::vector<Vector2> others = corners_around(b);
  points.insert(points.end(), others.begin(), others.end());
  std::ranges::sort(points, [](const Vector2& p, const Vector2& q) {
    return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
  });
  // Lower chain from left to right, upper chain back: only left turns stay.
  std::vector<Vector2> corners;
  for (const bool is_lower : {true, false}) {
    const std::size_t first = corners.size();
    for (const Vector2& point : points) {
      while (corners.size() >= first + 2 &&
             left_of(corners[corners.size() - 2], corners.back(), point) <= kSame)
        corners.pop_back();
      corners.push_back(point);
    }
    corners.pop_back();  // the first of the other chain
    if (is_lower) std::ranges::reverse(points);
  }
  return enclosed(std::move(corners));
}

std::vector<Vector2> outline(const Footprint& footprint, const Pose2& X_FB, int corners_of_disc) {
  std::vector<Vector2> corners;
  for (const Vector2& corner : footprint.polygon) corners.push_back(X_FB * corner);
  for (int i = 0; !footprint.is_polygon() && i < corners_of_disc; ++i)
    corners.push_back(X_FB *
                      Vector2(footprint.radius * direction(2.0 * std::numbers::pi * i / corners_of_disc)));
  return corners;
}

}  // namespace bw
