#include "components/program/calibrate/geometry_lines.hpp"

#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace bw {
namespace {

struct Value {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Where the value of a key of the document itself stands.
std::optional<Value> value_of(const std::string& text, std::string_view key) {
  const std::string start = std::string(key) + ":";
  std::size_t line = text.starts_with(start) ? 0 : text.find("\n" + start);
  if (line == std::string::npos) return std::nullopt;
  if (line > 0 || text.front() == '\n') ++line;
  const std::size_t begin = text.find_first_not_of(' ', line + start.size());
  const std::size_t end = text.find_first_of(" #\n\r", begin);
  if (begin == std::string::npos || text[begin] == '\n') return std::nullopt;
  return Value{begin, end == std::string::npos ? text.size() : end};
}

std::string in_digits(double value) { return fmt::format("{:.6g}", value); }

void replace(std::string& text, std::string_view key, double value) {
  const std::optional<Value> at = value_of(text, key);
  if (!at) throw std::runtime_error(fmt::format("there is no line `{}: VALUE` at its left margin", key));
  text.replace(at->begin, at->end - at->begin, in_digits(value));
}

}  // namespace

std::string geometry_lines(const WheelGeometry& geometry) {
  return fmt::format("wheel_radius: {}\nwheel_radius_ratio: {}\nwheel_separation: {}\n",
                     in_digits(geometry.radius), in_digits(geometry.ratio), in_digits(geometry.separation));
}

std::string with_geometry(const std::string& text, const WheelGeometry& geometry) {
  std::string result = text;
  replace(result, "wheel_radius", geometry.radius);
  replace(result, "wheel_separation", geometry.separation);
  if (value_of(result, "wheel_radius_ratio")) {
    replace(result, "wheel_radius_ratio", geometry.ratio);
    return result;
  }
  const std::size_t behind = result.find('\n', value_of(result, "wheel_radius")->end);
  const std::string line =
      fmt::format("wheel_radius_ratio: {}   # right over left, by `bandwagon calibrate odometry`\n",
                  in_digits(geometry.ratio));
  return behind == std::string::npos ? result + "\n" + line : result.insert(behind + 1, line);
}

}  // namespace bw
