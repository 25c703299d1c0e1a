#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>

#include "components/model/differential_drive.hpp"
#include "components/recordings/files/log_files.hpp"
#include "components/recordings/files/log_table.hpp"

namespace bw {
namespace {

/// A line "kind number number ...".
struct Entry {
  std::size_t line = 0;
  std::string kind;
  std::vector<double> values;
};

std::vector<Entry> read_entries(const std::string& file) {
  std::ifstream input(file);
  if (!input) throw std::runtime_error(file + ": cannot be opened");
  std::vector<Entry> entries;
  std::string text;
  for (std::size_t line = 1; next_line(input, text, file, line); ++line) {
    Entry entry{line, {}, {}};
    std::string_view rest = text;
    while (true) {
      rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
      if (rest.empty()) break;
      const std::string_view word = rest.substr(0, rest.find(' '));
      rest.remove_prefix(word.size());
      if (entry.kind.empty()) {
        entry.kind = word;
      } else {
        entry.values.push_back(to_number(word, file, line));
      }
    }
    if (!entry.kind.empty()) entries.push_back(std::move(entry));
  }
  return entries;
}

void require_values(const Entry& entry, std::size_t count, const std::string& file) {
  if (entry.values.size() != count) {
    fail_at(file, entry.line,
            entry.kind + " must have " + std::to_string(count) + " values, found " +
                std::to_string(entry.values.size()));
  }
}

/// odom2diff: t, left, right, lateral speed, distance of a wheel from the middle, three variances. That the
/// left wheel comes first and that the distance is half the separation is how the authors' own library turns
/// them into motion; with it dead reckoning ends 0.1 m from the reference, otherwise metres away.
void add_wheels(const Entry& entry, const std::string& file, RisingStamps& stamps, RecordedDrive& drive) {
  require_values(entry, 8, file);
  const auto& v = entry.values;
  const Time time = stamps.next(v[0], entry.line);
  for (const double speed : {v[1], v[2]})
    require_within(speed, -20.0, 20.0, "wheel speeds must lie within 20 m/s of 0", file, entry.line);
  require_within(v[4], 0.01, 10.0, "the distance of the wheels must lie in 0.01 ... 10 m", file, entry.line);
  require_within(v[5], 1e-12, 1e6, "the variance must be positive", file, entry.line);
  drive.wheel_separation = 2.0 * v[4];
  drive.wheel_variance = v[5];
  const Twist2 twist = to_twist({.left = v[1], .right = v[2]}, drive.wheel_separation);
  if (drive.odometry.empty()) {
    drive.odometry.push_back({time, {}, twist});
  } else {
    drive.odometry.push_back(advance(drive.odometry.back(), twist, time));
  }
}

/// range2: t, range, variance, anchor x, y, anchor number, 0.
RangeSample range_of(const Entry& entry, const std::string& file, RisingStamps& stamps) {
  require_values(entry, 7, file);
  const auto& v = entry.values;
  require_within(v[1], 0.0, 1e4, "the range must lie in 0 ... 10000 m", file, entry.line);
  require_within(v[2], 1e-12, 1e6, "the variance must be positive", file, entry.line);
  for (const double position : {v[3], v[4]})
    require_within(position, -1e5, 1e5, "anchors must lie within 100000 m of the origin", file, entry.line);
  return {stamps.next(v[0], entry.line), {v[3], v[4]}, v[1], v[2]};
}

/// point2: t, x, y, four zeros.
ReferencePose reference_of(const Entry& entry, const std::string& file, RisingStamps& stamps) {
  require_values(entry, 7, file);
  const auto& v = entry.values;
  for (const double position : {v[1], v[2]})
    require_within(position, -1e5, 1e5, "positions must lie within 100000 m of the origin", file, entry.line);
  return {stamps.next(v[0], entry.line), {v[1], v[2]}, {}};
}

}  // namespace

RecordedDrive read_labyrinth_log(const std::filesystem::path& folder) {
  RecordedDrive drive;
  const std::string input = (folder / "Indoor_UWB_Input.txt").string();
  RisingStamps wheel_stamps(input);
  RisingStamps range_stamps(input);
  for (const Entry& entry : read_entries(input)) {
    if (entry.kind == "odom2diff") {
      add_wheels(entry, input, wheel_stamps, drive);
    } else if (entry.kind == "range2") {
      drive.ranges.push_back(range_of(entry, input, range_stamps));
    } else {
      fail_at(input, entry.line, "a line must be odom2diff or range2");
    }
  }
  const std::string truth = (folder / "Indoor_UWB_GT.txt").string();
  RisingStamps truth_stamps(truth);
  for (const Entry& entry : read_entries(truth)) {
    if (entry.kind != "point2") fail_at(truth, entry.line, "a line must be point2");
    drive.truth.push_back(reference_of(entry, truth, truth_stamps));
  }
  return drive;
}

}  // namespace bw
