// Where people were, as somebody labelled it: a plain CSV.
//
//   time,id,x,y,frame,visible
//   33.0,1,0.67,1.12,odom,1
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw::people {

struct PersonLabel {
  std::size_t line = 0;  ///< in the file, from 1
  double time = 0.0;     ///< [s]
  std::uint32_t id = 0;
  Vector2 position{0.0, 0.0};  ///< in `frame` [m]
  std::string frame;
  bool is_visible = true;  ///< false: hidden, the position is guessed, and nobody has to see them
};

struct PersonLabels {
  std::string file;
  bool has_stamps = false;  ///< times are stamps; else they count from the first scan
  std::vector<PersonLabel> rows;
};

/// The first line names the columns, in any order: `time` (since the first scan) or `stamp` [s]; `id`, a
/// whole number from 1; `x`, `y` [m]; `frame`; and, if some are hidden, `visible`, 0 or 1. Times do not fall,
/// and nobody is labelled twice at one. Throws std::runtime_error naming file, line, column and rule.
PersonLabels read_person_labels(std::istream& input, const std::string& file);
PersonLabels read_person_labels(const std::string& file);

}  // namespace bw::people
