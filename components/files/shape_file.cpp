#include "components/files/shape_file.hpp"

#include <cmath>

#include "components/files/csv_file.hpp"

namespace bw {
namespace {

constexpr std::string_view kWallHeader = "x1_m,y1_m,x2_m,y2_m";
constexpr std::string_view kCircleHeader = "x_m,y_m,r_m";
constexpr double kFarthest = 1e5;  // [m]

void check_range(const CsvRow& row, const std::string& file) {
  for (const double value : row.values) {
    if (std::abs(value) > kFarthest) fail_at(file, row.line, "every value must lie within 100000 m");
  }
}

std::vector<Segment> to_walls(const std::vector<CsvRow>& rows, const std::string& file) {
  std::vector<Segment> walls;
  for (const CsvRow& row : rows) {
    check_range(row, file);
    walls.push_back({{row.values[0], row.values[1]}, {row.values[2], row.values[3]}});
  }
  return walls;
}

std::vector<Disc> to_circles(const std::vector<CsvRow>& rows, const std::string& file) {
  std::vector<Disc> circles;
  for (const CsvRow& row : rows) {
    check_range(row, file);
    if (row.values[2] < 0.0) fail_at(file, row.line, "r_m must not be negative");
    circles.push_back({{row.values[0], row.values[1]}, row.values[2]});
  }
  return circles;
}

}  // namespace

std::vector<Segment> read_walls(std::istream& input, const std::string& file) {
  return to_walls(read_csv(input, file, kWallHeader), file);
}
std::vector<Segment> read_walls(const std::string& file) {
  return to_walls(read_csv(file, kWallHeader), file);
}

std::vector<Disc> read_circles(std::istream& input, const std::string& file) {
  return to_circles(read_csv(input, file, kCircleHeader), file);
}
std::vector<Disc> read_circles(const std::string& file) {
  return to_circles(read_csv(file, kCircleHeader), file);
}

}  // namespace bw
