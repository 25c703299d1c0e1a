#include "components/lab/bench/course_generator.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "components/files/csv_file.hpp"

namespace bw {
namespace {

/// Of the file's frame: the benchmark drives from (-2.25, 3) along y.
CourseWorld world_of(const std::filesystem::path& file) {
  CourseWorld world{.name = file.stem().string(), .posts = {}};
  for (const CsvRow& row : read_csv(file.string(), "x_m,y_m,radius_m"))
    world.posts.push_back({{row.values[1] - 3.0, -2.25 - row.values[0]}, row.values[2]});
  return world;
}

// An empty field: two side walls of 0.15 m cells, 30 + 30 of 900 cells filled, the path 10 m straight on;
// 2.175 m to the middle of either wall, less a cylinder's radius.
TEST(CourseMeasures, OfAnEmptyFieldAreThoseOfItsWalls) {
  CourseWorld world;
  for (int along = -34; along < kCourseSide; ++along) {
    for (const int across : {0, kCourseSide - 1})
      world.posts.push_back({course_cell(along, across), kCoursePost});
  }
  const CourseMeasures m = measure(world);
  EXPECT_DOUBLE_EQ(m.filled, 60.0 / 900.0);
  EXPECT_NEAR(m.path_length, 10.0, 1e-9);
  EXPECT_NEAR(m.narrowest, 2.1, 0.01);
  // Closed off by a wall: no path.
  for (int across = 0; across < kCourseSide; ++across)
    world.posts.push_back({course_cell(15, across), kCoursePost});
  EXPECT_EQ(measure(world).path_length, 0.0);
  EXPECT_NEAR(measure(world).narrowest, 0.0, 1e-6);  // where two cylinders touch
}

TEST(CourseGenerator, SeedsGiveCoursesWithinTheRanges) {
  const CourseRanges ranges = given_ranges();
  std::set<std::size_t> sizes;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const GeneratedCourse course = generate_course(seed);
    EXPECT_TRUE(ranges.contain(course.measures));
    const CourseMeasures again = measure(course.world);
    EXPECT_EQ(again.filled, course.measures.filled);
    EXPECT_EQ(again.clearance, course.measures.clearance);
    const GeneratedCourse same = generate_course(seed);
    ASSERT_EQ(same.world.posts.size(), course.world.posts.size());
    for (std::size_t i = 0; i < same.world.posts.size(); ++i)
      EXPECT_EQ(same.world.posts[i].center, course.world.posts[i].center);
    sizes.insert(course.world.posts.size());
  }
  EXPECT_GT(sizes.size(), 10u);  // they differ
}

TEST(CourseGenerator, TellsWhereNothingFitsTheRanges) {
  CourseRanges ranges = given_ranges();
  ranges.least.filled = ranges.most.filled = 0.99;
  EXPECT_THROW(generate_course(1, ranges), std::runtime_error);
}

// The ranges are those of the given worlds, cut at a digit.
TEST(SharedCourses, SpanTheRangesOfTheGenerator) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED is not set";
  std::vector<CourseMeasures> measures;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(shared) / "data/barn_worlds")) {
    if (entry.path().extension() == ".csv") measures.push_back(measure(world_of(entry.path())));
  }
  ASSERT_EQ(measures.size(), 10u);
  const CourseRanges given = ranges_of(measures);
  const CourseRanges own = given_ranges();
  for (const auto measure :
       {&CourseMeasures::filled, &CourseMeasures::clearance, &CourseMeasures::narrowest}) {
    EXPECT_NEAR(own.least.*measure, given.least.*measure, 1e-3);
    EXPECT_NEAR(own.most.*measure, given.most.*measure, 1e-3);
    EXPECT_GE(own.least.*measure, given.least.*measure - 1e-6);
    EXPECT_LE(own.most.*measure, given.most.*measure + 1e-6);
  }
}

}  // namespace
}  // namespace bw
