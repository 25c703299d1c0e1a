#include "components/recordings/files/log_record.hpp"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "runtime/parameters/scalar_text.hpp"
#include "runtime/recording/bag/log_record.hpp"

namespace bw {

LogRecord log_record_of(const bag::Bag& bag, const std::string& path) {
  LogRecord log{.name = std::filesystem::path(path).stem().string()};
  const auto metadata = bag.metadata();
  const auto record = metadata.find(bag::kLogRecord);
  if (record == metadata.end()) return log;
  const auto text = [&](const char* name, std::string& value) {
    if (const auto found = record->second.find(name); found != record->second.end()) value = found->second;
  };
  const auto number = [&](const char* name) -> std::optional<double> {
    const auto found = record->second.find(name);
    if (found == record->second.end()) return std::nullopt;
    const std::optional<double> value = parse_number(found->second);
    if (value && std::isfinite(*value)) return value;
    throw std::runtime_error(
        fmt::format("{}: record {}: {} = '{}' is no number", path, bag::kLogRecord, name, found->second));
  };
  text("name", log.name);
  text("source", log.source);
  text("licence", log.licence);
  if (const auto start = number("start")) log.start = Time::seconds(*start);
  log.wheel_separation = number("wheel_separation");
  log.wheel_radius = number("wheel_radius");
  log.wheel_variance = number("wheel_variance");
  return log;
}

}  // namespace bw
