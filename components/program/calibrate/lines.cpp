#include "components/program/calibrate/lines.hpp"

namespace bw {

std::optional<std::string> Lines::wait(Duration limit) {
  if (auto line = next()) return line;
  if (const auto text = input_.wait(limit)) read_ += *text;
  return next();
}

std::optional<std::string> Lines::next() {
  const std::size_t end = read_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = read_.substr(0, end);
  read_.erase(0, end + 1);
  return line;
}

}  // namespace bw
