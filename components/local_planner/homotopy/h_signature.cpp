#include "components/local_planner/homotopy/h_signature.hpp"

#include <algorithm>
#include <cmath>

namespace bw::homotopy {
namespace {

using Complex = std::complex<double>;
constexpr double kSmallest = 1e-3;  // [m] between obstacles told apart, and between path and obstacle

Complex complex_of(const Vector2& p) { return {p.x(), p.y()}; }

std::vector<Complex> obstacle_points(const std::vector<Body>& bodies) {
  std::vector<Complex> points;
  for (const Body& body : bodies) {
    const Complex c = complex_of(body.representative);
    const auto close = [&](const Complex& other) { return std::abs(other - c) < kSmallest; };
    if (std::none_of(points.begin(), points.end(), close)) points.push_back(c);
  }
  return points;
}

// A_l of every obstacle.
std::vector<Complex> residues(const std::vector<Complex>& obstacles, const Course& course) {
  Vector2 low = course.start.cwiseMin(course.goal);
  Vector2 high = course.start.cwiseMax(course.goal);
  for (const Complex& c : obstacles) {
    low = low.cwiseMin(Vector2(c.real(), c.imag()));
    high = high.cwiseMax(Vector2(c.real(), c.imag()));
  }
  // Corners further from every obstacle than obstacles from each other: no A_l is small.
  const double margin = (high - low).norm();
  const Complex bottom_left = complex_of(low - Vector2(margin, margin));
  const Complex top_right = complex_of(high + Vector2(margin, margin));
  const std::size_t a = obstacles.size() / 2;
  std::vector<Complex> values;
  for (std::size_t l = 0; l < obstacles.size(); ++l) {
    // One factor over one factor, so that the product stays in range as long as possible.
    Complex value = 1.0;
    std::size_t factor = 0;
    for (std::size_t j = 0; j < obstacles.size(); ++j) {
      if (j == l) continue;
      value *= (obstacles[l] - (factor++ < a ? bottom_left : top_right)) / (obstacles[l] - obstacles[j]);
    }
    values.push_back(value);
  }
  return values;
}

}  // namespace

Complex h_signature(const Route& route, const std::vector<Body>& bodies, const Course& course) {
  const std::vector<Complex> obstacles = obstacle_points(bodies);
  const std::vector<Complex> weights = residues(obstacles, course);
  Complex sum = 0.0;
  Complex last = complex_of(course.start);
  const auto go_to = [&](const Complex& next) {
    for (std::size_t l = 0; l < obstacles.size(); ++l) {
      const Complex from = last - obstacles[l];
      const Complex to = next - obstacles[l];
      const double growth = std::log(std::max(std::abs(to), kSmallest) / std::max(std::abs(from), kSmallest));
      const Complex rotation = to * std::conj(from);
      sum += weights[l] * Complex(growth, std::atan2(rotation.imag() + 0.0, rotation.real()));
    }
    last = next;
  };
  for (const RoutePoint& p : route) go_to(complex_of(p.position));
  go_to(complex_of(course.goal));
  return sum;
}

bool same_h_signature(const Complex& h, const Complex& k, double threshold) {
  return std::abs(h.real() - k.real()) < threshold && std::abs(h.imag() - k.imag()) < threshold;
}

}  // namespace bw::homotopy
