// CPU time of global plans on inflated floors with walls, doors and clutter, start and goal more than half a
// side apart. Counters: median and largest time of one plan [ms], cells expanded. `HeapAStar` is the plain
// textbook search on the same grid and trips, to compare machines and maps with.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <queue>
#include <vector>

#include <benchmark/benchmark.h>

#include "components/global_planner/planner.hpp"
#include "runtime/base/quantile.hpp"
#include "tests/components/global_planner/random_floor.hpp"

namespace bw {
namespace {

constexpr int kMaps = 8;
constexpr int kTripsPerMap = 12;
const Footprint kRobot{0.3, {}};

double cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

struct Course {
  OccupancyGrid map;
  Planner planner;
  std::vector<test::Trip> trips;
};

std::vector<Course>& courses(int side) {
  static std::vector<std::pair<int, std::vector<Course>>> all;
  for (auto& [known, list] : all) {
    if (known == side) return list;
  }
  std::vector<Course> list;
  for (int i = 0; i < kMaps; ++i) {
    Random random(static_cast<std::uint64_t>(1000 + i));
    Course course{.map = test::random_floor(random, side)};
    course.planner.set_map(course.map, kRobot);
    for (int k = 0; k < kTripsPerMap; ++k) {
      course.trips.push_back(test::random_trip(random, course.planner.grid(), course.map));
    }
    list.push_back(std::move(course));
  }
  return all.emplace_back(side, std::move(list)).second;
}

void report(benchmark::State& state, const std::vector<double>& times, double expanded) {
  state.counters["median_ms"] = quantile(times, 0.5);
  state.counters["p99_ms"] = quantile(times, 0.99);
  state.counters["max_ms"] = quantile(times, 1.0);
  state.counters["expanded"] = expanded / static_cast<double>(times.size());
}

template <class Plan>
void measure(benchmark::State& state, Plan plan) {
  std::vector<Course>& list = courses(static_cast<int>(state.range(0)));
  std::vector<double> times;
  double expanded = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    for (Course& course : list) {
      for (const test::Trip& trip : course.trips) {
        const double before = cpu_ms();
        expanded += static_cast<double>(plan(course, trip));
        times.push_back(cpu_ms() - before);
      }
    }
  }
  report(state, times, expanded);
}

void GlobalPlan(benchmark::State& state) {
  measure(state, [](Course& course, const test::Trip& trip) {
    const PathResult result = course.planner.plan(trip.start, trip.goal);
    if (result.status != PathStatus::ok) std::abort();
    return result.expanded;
  });
}
BENCHMARK(GlobalPlan)->Arg(100)->Arg(200)->Arg(400)->Arg(1000)->Arg(2000)->Unit(benchmark::kMillisecond);

// Goal in another component: every reason must come at once.
void Unreachable(benchmark::State& state) {
  measure(state, [](Course& course, const test::Trip& trip) {
    const Pose2 in_a_wall{course.map.origin.x() + 0.02, course.map.origin.y() + 0.02, 0.0};
    const PathResult result = course.planner.plan(trip.start, in_a_wall);
    if (result.status != PathStatus::goal_blocked) std::abort();
    return result.expanded;
  });
}
BENCHMARK(Unreachable)->Arg(1000)->Unit(benchmark::kMillisecond);

void SetMap(benchmark::State& state) {
  std::vector<Course>& list = courses(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) {
    Planner planner;
    benchmark::DoNotOptimize(planner.set_map(list[0].map, kRobot));
  }
}
BENCHMARK(SetMap)->Arg(400)->Arg(1000)->Unit(benchmark::kMillisecond);

// The same for a rectangle, which also has headings.
void SetMapOfARectangle(benchmark::State& state) {
  std::vector<Course>& list = courses(static_cast<int>(state.range(0)));
  const Footprint rectangle{std::hypot(0.255, 0.215),
                            {{0.255, 0.215}, {-0.255, 0.215}, {-0.255, -0.215}, {0.255, -0.215}}};
  for ([[maybe_unused]] auto _ : state) {
    Planner planner;
    benchmark::DoNotOptimize(planner.set_map(list[0].map, rectangle));
  }
}
BENCHMARK(SetMapOfARectangle)->Arg(400)->Arg(1000)->Unit(benchmark::kMillisecond);

void HeapAStar(benchmark::State& state) {
  measure(state, [](Course& course, const test::Trip& trip) {
    const SearchGrid& grid = course.planner.grid();
    const auto cell = [&grid](const Pose2& pose) {
      const auto [x, y] = grid.cell_of(pose.position());
      return grid.index(x, y);
    };
    const std::size_t goal = cell(trip.goal);
    const auto stride = static_cast<std::size_t>(grid.stride());
    const auto octile = [&](std::size_t i) {
      const std::size_t row = i / stride;
      const std::size_t goal_row = goal / stride;
      const double dx = std::abs(static_cast<double>(i % stride) - static_cast<double>(goal % stride));
      const double dy = std::abs(static_cast<double>(row) - static_cast<double>(goal_row));
      return std::max(dx, dy) + 0.41421356 * std::min(dx, dy);
    };
    std::vector<float> g(grid.cells().size(), 1e30F);
    std::vector<char> closed(g.size(), 0);
    using Entry = std::pair<float, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    g[cell(trip.start)] = 0.0F;
    open.push({0.0F, cell(trip.start)});
    std::size_t expanded = 0;
    while (!open.empty()) {
      const std::size_t i = open.top().second;
      open.pop();
      if (i == goal) break;
      if (closed[i] != 0) continue;
      closed[i] = 1;
      ++expanded;
      for (unsigned d = 0; d < 8; ++d) {
        if ((grid.cells()[i].moves >> d & 1u) == 0) continue;
        const std::size_t n = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + kSteps[d].dx +
                                                       kSteps[d].dy * static_cast<std::ptrdiff_t>(stride));
        const float next = g[i] + static_cast<float>(step_cost(grid.cells()[n].cost, d % 2 == 1)) /
                                      static_cast<float>(kUnit);
        if (next >= g[n]) continue;
        g[n] = next;
        open.push({next + static_cast<float>(octile(n)), n});
      }
    }
    return expanded;
  });
}
BENCHMARK(HeapAStar)->Arg(400)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bw

BENCHMARK_MAIN();
