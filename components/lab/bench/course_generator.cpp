#include "components/lab/bench/course_generator.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr int kSide = kCourseSide;
constexpr int kBefore = 34;  // rows of the open place before the field, the first of them a wall

/// [along][across]; the outermost cells across are the side walls.
using Field = std::array<std::array<bool, kSide>, kSide>;

int filled_neighbours(const Field& field, int along, int across) {
  int count = 0;
  for (int i = along - 1; i <= along + 1; ++i) {
    for (int j = across - 1; j <= across + 1; ++j) {
      if (i < 0 || i >= kSide || (i == along && j == across)) continue;
      count += field[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] ? 1 : 0;
    }
  }
  return count;
}

Field smoothed(const Field& field) {
  Field result = field;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 1; j < kSide - 1; ++j) {
      const int count = filled_neighbours(field, i, j);
      bool& cell = result[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      if (count >= 5) cell = true;
      if (count < 2) cell = false;
    }
  }
  return result;
}

Field draw(Random& random) {
  Field field{};
  const double probability = random.uniform(0.1, 0.45);
  const int smoothings = 1 + static_cast<int>(random.uniform(0.0, 3.0));
  for (auto& row : field) {
    for (std::size_t j = 0; j < row.size(); ++j)
      row[j] = j == 0 || j + 1 == row.size() || random.uniform() < probability;
  }
  for (int i = 0; i < smoothings; ++i) field = smoothed(field);
  return field;
}

CourseWorld world_of(const Field& field) {
  CourseWorld world;
  const auto add = [&](int along, int across) {
    world.posts.push_back({course_cell(along, across), kCoursePost});
  };
  for (int along = -kBefore; along < 0; ++along) {
    for (int across = 0; across < kSide; ++across) {
      if (along == -kBefore || across == 0 || across == kSide - 1) add(along, across);
    }
  }
  for (int along = 0; along < kSide; ++along) {
    for (int across = 0; across < kSide; ++across) {
      if (field[static_cast<std::size_t>(along)][static_cast<std::size_t>(across)]) add(along, across);
    }
  }
  return world;
}

}  // namespace

CourseRanges given_ranges() {
  return {.least = {.filled = 0.104, .path_length = 10.0, .clearance = 0.961, .narrowest = 0.375},
          .most = {.filled = 0.266, .path_length = 10.46, .clearance = 1.489, .narrowest = 0.975}};
}

GeneratedCourse generate_course(std::uint64_t seed, const CourseRanges& ranges) {
  constexpr int kMaxDraws = 100'000;
  Random random(seed);
  GeneratedCourse course;
  while (course.draws < kMaxDraws) {
    ++course.draws;
    course.world = world_of(draw(random));
    const double filled =
        static_cast<double>(course.world.posts.size() - (kSide + 2 * (kBefore - 1))) / (kSide * kSide);
    // Counted before it is searched: most draws end here.
    if (filled < ranges.least.filled || filled > ranges.most.filled) continue;
    course.measures = measure(course.world);
    if (!ranges.contain(course.measures)) continue;
    course.world.name = "seed " + std::to_string(seed);
    return course;
  }
  throw std::runtime_error("seed " + std::to_string(seed) + ": no course within the ranges");
}

}  // namespace bw
