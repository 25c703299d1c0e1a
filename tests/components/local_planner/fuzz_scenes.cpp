#include "tests/components/local_planner/fuzz_scenes.hpp"

#include <array>
#include <limits>
#include <vector>

#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class List>
auto& any_of(List&& list, Random& random) {
  return list[random_index(random, std::size(list))];
}

double unsound_number(Random& random) {
  constexpr std::array kNumbers{kNan, kInfinity, -kInfinity, 1e300, -1e300, 1e9};
  return any_of(kNumbers, random);
}

// 1e-12 ... 1e6, evenly by decade: whatever counts as a number.
double any_magnitude(Random& random) { return std::pow(10.0, random.uniform(-12.0, 5.99)); }

struct Trouble {
  const char* what;
  bool unsound;
  void (*make)(Random& random, PlanningProblem& problem);
};

void thousand_obstacles(Random& random, PlanningProblem& p) {
  for (int i = 0; i < 1000; ++i) {
    const Vector2 at = random_point(random, 6.0);
    if (i % 3 == 0) p.obstacles.discs.push_back({at, random.uniform(0.0, 0.3)});
    if (i % 3 == 1) p.obstacles.segments.push_back({at, at + random_point(random, 0.5)});
    if (i % 3 == 2) p.obstacles.points.push_back(at);
  }
}

void hundreds_of_movers(Random& random, PlanningProblem& p) {
  for (std::uint32_t i = 0; i < 200; ++i) {
    Mover mover = random_mover(random, 8.0);
    mover.id = i;
    for (PredictedPosition& x : mover.predictions) {
      const double scale = std::pow(10.0, random.uniform(-10.0, 10.0));
      x.covariance << random.normal(), random.normal(), random.normal(), random.normal();
      x.covariance *= scale;  // neither symmetric nor positive
    }
    p.movers.push_back(std::move(mover));
  }
}

void disordered_predictions(Random& random, PlanningProblem& p) {
  for (Mover& mover : p.movers) {
    for (int k = 0; k < 5; ++k) {
      const double time = random.uniform() < 0.3 ? 0.4 : random.uniform(-1.0, 3.0);
      mover.predictions.push_back({time, random_point(random, 5.0), Eigen::Matrix2d::Zero()});
    }
  }
}

void ring(Random& random, PlanningProblem& p) {
  const double radius = random.uniform(0.25, 1.0);
  for (int i = 0; i < 40; ++i) p.obstacles.points.push_back(p.pose * Vector2(radius * direction(0.157 * i)));
}

void polygon(Random& random, PlanningProblem& p) {
  const double a = random.uniform(0.05, 0.6), b = random.uniform(0.05, 0.6);
  const std::array<std::vector<Vector2>, 7> kShapes{{{{-a, -b}, {a, -b}, {a, b}, {-a, b}},
                                                     {{-a, -b}, {-a, b}, {a, b}, {a, -b}},  // clockwise
                                                     {{-a, -b}, {a, -b}, {0.0, 0.0}, {a, b}, {-a, b}},
                                                     {{-a, -b}, {a, b}, {a, -b}, {-a, b}},  // crosses itself
                                                     {{-a, 0.0}, {0.0, 0.0}, {a, 0.0}},     // no area
                                                     {{a, b}, {a, b}, {a, b}, {a, b}},
                                                     {{-a, 0.0}, {a, 0.0}}}};
  p.footprint.polygon = any_of(kShapes, random);
  p.footprint.radius = std::hypot(a, b);
}

void unsound_number_somewhere(Random& random, PlanningProblem& p) {
  const double x = unsound_number(random);
  Mover mover = random_mover(random, 3.0);
  mover.predictions = {{0.5, {1.0, 1.0}, Eigen::Matrix2d::Zero()}};
  Mover &at = mover, in_prediction = mover, in_time = mover, in_velocity = mover;
  in_prediction.predictions[0].position.y() = x;
  in_time.predictions[0].time = x;
  in_velocity.velocity.x() = x;
  switch (random_index(random, 17)) {
    case 0:
      p.obstacles.points.push_back({x, 0.0});
      break;
    case 1:
      p.obstacles.points.push_back({0.0, x});
      break;
    case 2:
      p.obstacles.discs.push_back({{x, 1.0}, 0.2});
      break;
    case 3:
      p.obstacles.discs.push_back({{1.0, 1.0}, x});
      break;
    case 4:
      p.obstacles.segments.push_back({{x, 1.0}, {0.0, 0.0}});
      break;
    case 5:
      p.obstacles.segments.push_back({{1.0, 1.0}, {0.0, x}});
      break;
    case 6:
      at.position.x() = x;
      p.movers.push_back(at);
      break;
    case 7:
      at.radius = x;
      p.movers.push_back(at);
      break;
    case 8:
      p.movers.push_back(in_velocity);
      break;
    case 9:
      p.movers.push_back(in_prediction);
      break;
    case 10:
      p.movers.push_back(in_time);
      break;
    case 11:
      p.pose.x = x;
      break;
    case 12:
      p.pose.theta = x;
      break;
    case 13:
      p.plan.push_back({0.0, x, 0.0});
      break;
    case 14:
      p.plan.push_back({0.0, 0.0, x});
      break;
    case 15:
      p.footprint.radius = x;
      break;
    default:
      p.footprint.polygon = {{0.1, 0.1}, {x, 0.2}, {-0.1, -0.1}};
      break;
  }
}

void negative_size(Random& random, PlanningProblem& p) {
  Mover mover = random_mover(random, 3.0);
  mover.radius = -0.1;
  switch (random_index(random, 3)) {
    case 0:
      p.obstacles.discs.push_back({{1.0, 1.0}, -0.1});
      break;
    case 1:
      p.movers.push_back(mover);
      break;
    default:
      p.footprint.radius = -0.3;
      break;
  }
}

std::array<double*, 7> numbers_of(Limits& l) {
  return {&l.v_max, &l.v_back_max, &l.omega_max, &l.acc_max, &l.alpha_max, &l.jerk_max, &l.stop_deceleration};
}

void unsound_limit(Random& random, PlanningProblem& p) {
  constexpr std::array kNumbers{kNan, kInfinity, -1.0, 1e300};
  *any_of(numbers_of(p.limits), random) = any_of(kNumbers, random);
}

void extreme_limits(Random& random, PlanningProblem& p) {
  for (double* limit : numbers_of(p.limits)) {
    if (random.uniform() < 0.4) *limit = any_magnitude(random);
  }
  if (random.uniform() < 0.5) p.limits.v_back_max = 0.0;
}

void unsound_period(Random& random, PlanningProblem& p) {
  constexpr std::array kNumbers{kNan, kInfinity, -kInfinity, 0.0, -0.1, 1e300};
  (random.uniform() < 0.5 ? p.control_period : p.command_lead) = any_of(kNumbers, random);
}

void extreme_period(Random& random, PlanningProblem& p) {
  (random.uniform() < 0.5 ? p.control_period : p.command_lead) = std::pow(10.0, random.uniform(-4.0, 2.0));
}

void extreme_twist(Random& random, PlanningProblem& p) {
  p.twist.v = any_magnitude(random) * (random.uniform() < 0.5 ? 1.0 : -1.0);
  if (random.uniform() < 0.7) p.twist.omega = any_magnitude(random) * (random.uniform() < 0.5 ? 1.0 : -1.0);
}

void extreme_sizes(Random& random, PlanningProblem& p) {
  p.footprint.radius = random.uniform() < 0.5 ? 0.0 : p.footprint.radius;
  if (random.uniform() < 0.2) p.footprint.radius = any_magnitude(random);
  p.obstacles.discs.push_back({random_point(random, 1e5), any_magnitude(random)});
  p.obstacles.segments.push_back({random_point(random, 9e5), random_point(random, 9e5)});
  for (Mover& mover : p.movers) {
    mover.radius = random.uniform() < 0.5 ? 0.0 : any_magnitude(random);
    mover.velocity *= any_magnitude(random);
  }
}

constexpr Trouble kTroubles[] = {
    {"disc on the robot", false,
     [](Random&, PlanningProblem& p) {
       p.obstacles.discs.push_back({p.pose.position(), 0.3});
     }},
    {"point on the robot", false,
     [](Random&, PlanningProblem& p) { p.obstacles.points.push_back(p.pose.position()); }},
    {"wall through the robot", false,
     [](Random&, PlanningProblem& p) {
       p.obstacles.segments.push_back({p.pose * Vector2(-1.0, -1.0), p.pose * Vector2(1.0, 1.0)});
     }},
    {"disc on the goal", false,
     [](Random& r, PlanningProblem& p) {
       if (!p.plan.empty()) p.obstacles.discs.push_back({p.plan.back().position(), r.uniform(0.0, 1.0)});
     }},
    {"goal is the start", false,
     [](Random& r, PlanningProblem& p) {
       if (!p.plan.empty()) p.plan.back() = r.uniform() < 0.5 ? p.pose : Pose2{p.pose.x, p.pose.y, 3.0};
     }},
    {"plan of one place", false,
     [](Random& r, PlanningProblem& p) {
       for (Pose2& x : p.plan) x = {1.0, 1.0, r.uniform(-3.0, 3.0)};
     }},
    {"plan of one pose", false,
     [](Random&, PlanningProblem& p) {
       if (!p.plan.empty()) p.plan.resize(1);
     }},
    {"plan that begins elsewhere", false,
     [](Random& r, PlanningProblem& p) {
       if (!p.plan.empty()) p.plan.front() = {r.uniform(-50.0, 50.0), 0.0, 0.0};
     }},
    {"plan of 2000 poses", false,
     [](Random& r, PlanningProblem& p) {
       for (int i = 0; i < 2000; ++i) p.plan.push_back({r.uniform(-9.0, 9.0), r.uniform(-9.0, 9.0), 0.0});
     }},
    {"no plan", false, [](Random&, PlanningProblem& p) { p.plan.clear(); }},
    {"mover on the robot", false,
     [](Random&, PlanningProblem& p) {
       Mover m;
       m.position = p.pose.position();
       p.movers.push_back(m);
     }},
    {"headings of many turns", false,
     [](Random& r, PlanningProblem& p) {
       p.pose.theta = r.uniform(-9e5, 9e5);
       for (Pose2& x : p.plan) x.theta = r.uniform(-9e5, 9e5);
     }},
    {"everything twice", false,
     [](Random&, PlanningProblem& p) {
       const StaticObstacles o = p.obstacles;
       p.obstacles.points.insert(p.obstacles.points.end(), o.points.begin(), o.points.end());
       p.obstacles.discs.insert(p.obstacles.discs.end(), o.discs.begin(), o.discs.end());
       for (const Disc& d : o.discs) p.obstacles.segments.push_back({d.center, d.center});
     }},
    {"far from the origin", false,
     [](Random& r, PlanningProblem& p) {
       p = moved(p, {r.uniform(-9e5, 9e5), r.uniform(-9e5, 9e5), r.uniform(-3.0, 3.0)});
     }},
    {"time runs back", false, [](Random&, PlanningProblem& p) { p.now = Time::seconds(-100.0); }},
    {"thousand obstacles", false, thousand_obstacles},
    {"hundreds of movers", false, hundreds_of_movers},
    {"disordered predictions", false, disordered_predictions},
    {"ring", false, ring},
    {"polygon", false, polygon},
    {"extreme limits", false, extreme_limits},
    {"extreme period", false, extreme_period},
    {"extreme twist", false, extreme_twist},
    {"extreme sizes", false, extreme_sizes},
    {"unsound number", true, unsound_number_somewhere},
    {"negative size", true, negative_size},
    {"unsound limit", true, unsound_limit},
    {"unsound period", true, unsound_period},
    {"unsound twist", true,
     [](Random& r, PlanningProblem& p) {
       (r.uniform() < 0.5 ? p.twist.v : p.twist.omega) = unsound_number(r);
     }},
};

}  // namespace

FuzzScene fuzz_scene(Random& random) {
  FuzzScene scene{.problem = random_scene(random)};
  constexpr std::array kBudgets{1, 2, 3, 10, 100, 100, 100, 1'000'000};
  scene.problem.budget.max_iterations = any_of(kBudgets, random);
  std::vector<const Trouble*> troubles;
  for (std::size_t i = random_index(random, 4); i > 0; --i) troubles.push_back(&any_of(kTroubles, random));
  // What is unsound comes last, so that nothing mends it.
  std::stable_sort(troubles.begin(), troubles.end(),
                   [](const Trouble* l, const Trouble* r) { return !l->unsound && r->unsound; });
  for (const Trouble* trouble : troubles) {
    trouble->make(random, scene.problem);
    scene.what += std::string(scene.what.empty() ? "" : ", ") + trouble->what;
    scene.unsound = scene.unsound || trouble->unsound;
  }
  return scene;
}

}  // namespace bw
