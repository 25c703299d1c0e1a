// Courses of cylinders from seeds, as hard as the given ones.
#pragma once

#include <cstdint>
#include <vector>

#include "components/lab/bench/course_world.hpp"

namespace bw {

/// What the ten worlds of the benchmark that are at hand span, rounded inwards to the last digit; a test
/// measures them again.
CourseRanges given_ranges();

struct GeneratedCourse {
  CourseWorld world;
  CourseMeasures measures;
  int draws = 0;  ///< until one lay within the ranges
};

/// The course of a seed: each cell of the field between the side walls is filled with a probability drawn
/// from 0.1 to 0.45, then a cell with five filled neighbours or more of eight is filled and one with fewer
/// than two emptied, one to three times over.
/// Drawn again until filled share, clearance along the shortest path and width of the widest path lie within
/// `ranges`. Throws std::runtime_error when 100,000 draws did not.
GeneratedCourse generate_course(std::uint64_t seed, const CourseRanges& ranges = given_ranges());

}  // namespace bw
