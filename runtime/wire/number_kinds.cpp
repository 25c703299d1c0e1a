#include "runtime/wire/number_kinds.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace bw {
namespace {

constexpr double kExact = 9007199254740992.0;  // whole numbers are exact in a double up to here

/// Lowest and highest whole number of a kind; nothing for what is no whole number.
std::optional<std::pair<double, double>> range_of(Kind kind) {
  switch (kind) {
    case Kind::kBoolean:
      return {{0, 1}};
    case Kind::kByte:
    case Kind::kUint8:
      return {{0, 255}};
    case Kind::kInt8:
      return {{-128, 127}};
    case Kind::kInt16:
      return {{-32768, 32767}};
    case Kind::kUint16:
      return {{0, 65535}};
    case Kind::kInt32:
      return {{-2147483648.0, 2147483647.0}};
    case Kind::kUint32:
      return {{0, 4294967295.0}};
    case Kind::kInt64:
      return {{-kExact, kExact}};
    case Kind::kUint64:
      return {{0, kExact}};
    case Kind::kFloat32:
    case Kind::kFloat64:
    case Kind::kString:
    case Kind::kMessage:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> broken_rule(Kind kind, double value) {
  if (const auto range = range_of(kind)) {
    if (value >= range->first && value <= range->second && value == std::trunc(value)) return std::nullopt;
    return fmt::format("must be a whole number from {:.0f} to {:.0f}", range->first, range->second);
  }
  const bool too_large = kind == Kind::kFloat32 && std::isfinite(value) &&
                         std::abs(value) > double{std::numeric_limits<float>::max()};
  if (too_large) return "is too large for a float32";
  return std::nullopt;
}

void write_number(Kind kind, double value, CdrWriter& writer) {
  switch (kind) {
    case Kind::kBoolean:
    case Kind::kByte:
    case Kind::kUint8:
      return writer.write(static_cast<std::uint8_t>(value));
    case Kind::kInt8:
      return writer.write(static_cast<std::int8_t>(value));
    case Kind::kInt16:
      return writer.write(static_cast<std::int16_t>(value));
    case Kind::kUint16:
      return writer.write(static_cast<std::uint16_t>(value));
    case Kind::kInt32:
      return writer.write(static_cast<std::int32_t>(value));
    case Kind::kUint32:
      return writer.write(static_cast<std::uint32_t>(value));
    case Kind::kInt64:
      return writer.write(static_cast<std::int64_t>(value));
    case Kind::kUint64:
      return writer.write(static_cast<std::uint64_t>(value));
    case Kind::kFloat32:
      return writer.write(static_cast<float>(value));
    case Kind::kFloat64:
      return writer.write(value);
    case Kind::kString:
    case Kind::kMessage:
      break;
  }
}

}  // namespace bw
