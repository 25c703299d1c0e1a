#include "components/lab/experiments/passing.hpp"

namespace bw {
namespace {

// Distance of the robot from the person's line, positive on its left.
double side(const Vector2& position, const StraightWalk& person, const Vector2& along) {
  const Vector2 d = position - person.start;
  return along.x() * d.y() - along.y() * d.x();
}

}  // namespace

std::string_view name_of(Passing passing) {
  switch (passing) {
    case Passing::behind:
      return "behind";
    case Passing::in_front:
      return "in_front";
    case Passing::not_crossed:
      break;
  }
  return "not_crossed";
}

Passing passing(const std::vector<TimedPosition>& path, const StraightWalk& person) {
  if (path.size() < 2) return Passing::not_crossed;
  const double speed = person.velocity.norm();
  const Vector2 along = person.velocity / speed;
  if (side(path.front().position, person, along) * side(path.back().position, person, along) >= 0.0)
    return Passing::not_crossed;
  for (std::size_t i = path.size() - 1; i > 0; --i) {
    const double before = side(path[i - 1].position, person, along);
    const double after = side(path[i].position, person, along);
    if (before * after > 0.0 || before == 0.0) continue;
    const double s = before / (before - after);
    const double time = path[i - 1].time + s * (path[i].time - path[i - 1].time);
    const Vector2 position = path[i - 1].position + s * (path[i].position - path[i - 1].position);
    return speed * time > along.dot(position - person.start) ? Passing::behind : Passing::in_front;
  }
  return Passing::not_crossed;
}

}  // namespace bw
