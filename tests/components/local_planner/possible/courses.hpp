// Places with nobody there, that look as if there were: a gap in a wall with posts about it, a field of
// cylinders.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "components/model/obstacles.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

struct Course {
  std::string name;
  std::vector<Segment> walls;         ///< in map
  bool walls_are_on_the_map = false;  ///< else the map is empty floor
  std::vector<Disc> posts;            ///< never on the map
  Pose2 start;
  Pose2 goal;
  double from = 0.0;  ///< x [m] between which the time is taken
  double to = 0.0;
};

/// A gap as wide as twice the robot's radius (0.3 m) and 0.2 m, on the map; one post or two, a pair of legs
/// apart, before, beside or behind it, by turns. Posts leave as much room as the gap does.
Course gap_course(int number);

/// 10 m through cylinders of 3 to 15 cm, any two of them as far apart as the gap is wide; no map.
Course cylinder_course(int number);

/// A field of cylinders from a file x_m,y_m,radius_m, seen so that the path leads along x; no map.
Course course_of_file(const std::filesystem::path& file);

/// Who tells of people.
enum class Senses {
  none,      ///< nobody: the detector is off
  own,       ///< the detector and the tracker
  possible,  ///< a track of confidence 0.49 on every post
  person,    ///< a track of confidence 1 on every post
};

struct CourseDrive {
  bool reached = false;
  int collisions = 0;
  std::optional<double> time;   ///< from `from` to `to` [s]; nothing: it never came there
  double most_confident = 0.0;  ///< track of the drive (senses none and own)
  double confirmed = 0.0;       ///< confirmed tracks at once, on average
};

CourseDrive drive_course(const Course& course, const std::string& planner, Senses senses);

}  // namespace bw
