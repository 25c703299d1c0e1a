#include "components/local_planner/homotopy/explore.hpp"

#include <algorithm>
#include <limits>

#include "components/local_planner/homotopy/class_search.hpp"
#include "components/local_planner/homotopy/roadmap.hpp"
#include "components/local_planner/homotopy/segment_distance.hpp"

namespace bw::homotopy {
namespace {

Path path_of(const std::vector<Vector2>& points, const Exploration& so_far, const HomotopyOptions& options) {
  Path path;
  path.route = route_at_speed(points, so_far.course.v_max);
  path.length = path.route.back().time * so_far.course.v_max;
  path.signature = signature_of(path.route, so_far.bodies, so_far.course, options);
  return path;
}

// From the robot to the end of the plan's segment nearest to it, and on along the plan.
std::vector<Vector2> plan_points(const PlanningProblem& problem) {
  const Vector2 robot = problem.pose.position();
  std::vector<Vector2> points{robot};
  std::size_t next = problem.plan.size() - 1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < problem.plan.size(); ++i) {
    const Segment leg{problem.plan[i].position(), problem.plan[i + 1].position()};
    const double distance = squared_distance(robot, leg);
    if (distance >= nearest) continue;
    nearest = distance;
    next = i + 1;
  }
  for (std::size_t i = next; i < problem.plan.size(); ++i) points.push_back(problem.plan[i].position());
  return points;
}

bool uses_class(const Exploration& so_far, const Signature& signature, const HomotopyOptions& options) {
  return std::any_of(so_far.in_use.begin(), so_far.in_use.end(),
                     [&](const Signature& s) { return same_class(s, signature, options); });
}

// One path per class; a shorter one takes the place of a longer one, the plan keeps its own.
void add(Path path, Exploration& so_far, const HomotopyOptions& options) {
  if (uses_class(so_far, path.signature, options)) return;
  for (Path& known : so_far.paths) {
    if (!same_class(known.signature, path.signature, options)) continue;
    if (!known.is_plan && path.length < known.length) known = std::move(path);
    return;
  }
  so_far.paths.push_back(std::move(path));
}

std::size_t classes_in_use(const Exploration& so_far, const HomotopyOptions& options) {
  std::size_t count = 0;
  for (auto it = so_far.in_use.begin(); it != so_far.in_use.end(); ++it) {
    count += std::none_of(so_far.in_use.begin(), it,
                          [&](const Signature& s) { return same_class(s, *it, options); });
  }
  return count;
}

void search(Exploration& so_far, std::size_t room, const HomotopyOptions& options) {
  const auto visit = [&](const std::vector<Vector2>& points, double) {
    add(path_of(points, so_far, options), so_far, options);
    return so_far.paths.size() < room;
  };
  const Roadmap map = options.method == Vertices::roadmap
                          ? random_roadmap(so_far.course, so_far.bodies, options)
                          : keypoint_roadmap(so_far.course, so_far.bodies, options);
  so_far.expansions =
      options.search == SearchOrder::depth_first
          ? search_depth_first(map, options.max_expansions, visit)
          : search_best_first(map, so_far.bodies, so_far.course, options.max_expansions, visit);
}

void name_classes(Exploration& so_far) {
  std::vector<std::vector<double>> windings;
  for (const Signature& s : so_far.in_use) windings.push_back(s.winding);
  for (const Path& path : so_far.paths) windings.push_back(path.signature.winding);
  const std::vector<std::string> labels = class_labels(windings);
  const auto split = labels.begin() + static_cast<std::ptrdiff_t>(so_far.in_use.size());
  so_far.in_use_labels.assign(labels.begin(), split);
  for (std::size_t k = 0; k < so_far.paths.size(); ++k) {
    so_far.paths[k].label = split[static_cast<std::ptrdiff_t>(k)];
  }
}

}  // namespace

Signature signature_of(const Route& route, const std::vector<Body>& bodies, const Course& course,
                       const HomotopyOptions& options) {
  Signature signature{winding(route, bodies, course), {0.0, 0.0}};
  if (options.signature == ClassMeasure::h_signature)
    signature.h_signature = h_signature(route, bodies, course);
  return signature;
}

bool same_class(const Signature& l, const Signature& r, const HomotopyOptions& options) {
  if (options.signature == ClassMeasure::h_signature) {
    return same_h_signature(l.h_signature, r.h_signature, kHSignatureThreshold);
  }
  return same_winding(l.winding, r.winding);
}

Exploration explore(const PlanningProblem& problem, double clearance, const std::vector<Route>& in_use,
                    const HomotopyOptions& options) {
  Exploration result;
  result.course = {problem.pose.position(), problem.plan.back().position(),
                   inscribed_radius(problem.footprint), clearance, problem.limits.v_max};
  result.bodies = bodies_of(problem.obstacles, problem.movers, result.course, options);
  for (const Route& route : in_use) {
    result.in_use.push_back(signature_of(route, result.bodies, result.course, options));
  }
  const std::size_t used = classes_in_use(result, options);
  const auto wanted = static_cast<std::size_t>(options.max_number_classes);
  const std::size_t room = wanted > used ? wanted - used : 0;
  if (room > 0) {
    Path plan = path_of(plan_points(problem), result, options);
    plan.is_plan = true;
    add(std::move(plan), result, options);
    if (result.paths.size() < room && !result.bodies.empty()) search(result, room, options);
    const auto after_plan = result.paths.begin() + (!result.paths.empty() && result.paths.front().is_plan);
    std::stable_sort(after_plan, result.paths.end(),
                     [](const Path& l, const Path& r) { return l.length < r.length; });
  }
  name_classes(result);
  return result;
}

}  // namespace bw::homotopy
