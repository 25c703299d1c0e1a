#include "runtime/remote/foxglove/closest_type.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace bw::foxglove {
namespace {

constexpr double kWhole = 9007199254740992.0;  // up to here a double holds every whole number

std::optional<std::int64_t> whole(double value) {
  if (!(std::abs(value) <= kWhole) || value != std::floor(value)) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

template <class Number>
std::optional<ParameterValue> as_integers(const std::vector<Number>& list) {
  std::vector<std::int64_t> integers;
  for (const Number number : list) {
    const auto one = whole(static_cast<double>(number));
    if (!one) return std::nullopt;
    integers.push_back(*one);
  }
  return ParameterValue(std::move(integers));
}

std::optional<ParameterValue> as_bytes(const std::vector<std::int64_t>& list) {
  const auto is_byte = [](std::int64_t number) { return number >= 0 && number <= 255; };
  if (!std::ranges::all_of(list, is_byte)) return std::nullopt;
  std::vector<std::uint8_t> bytes;
  for (const std::int64_t number : list) bytes.push_back(static_cast<std::uint8_t>(number));
  return ParameterValue(std::move(bytes));
}

bool is_empty_list(const ParameterValue& value) {
  return std::visit(
      []<class T>(const T& held) {
        if constexpr (std::is_same_v<T, std::string>) {
          return false;
        } else if constexpr (requires { held.empty(); }) {
          return held.empty();
        } else {
          return false;
        }
      },
      value);
}

/// A list of the type of `like` with nothing in it.
ParameterValue empty_like(const ParameterValue& like) {
  return std::visit([]<class T>(const T&) { return ParameterValue(T{}); }, like);
}

}  // namespace

ParameterValue closest_type(const ParameterValue& value, const ParameterValue& like) {
  const ParameterType wanted = type_of(like);
  if (type_of(value) == wanted) return value;
  if (is_empty_list(value)) return wanted >= ParameterType::byte_list ? empty_like(like) : value;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    if (wanted == ParameterType::floating_point) return static_cast<double>(*integer);
  }
  if (const auto* number = std::get_if<double>(&value)) {
    if (wanted == ParameterType::integer && whole(*number)) return *whole(*number);
  }
  if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&value)) {
    if (wanted == ParameterType::double_list) return std::vector<double>(integers->begin(), integers->end());
    if (wanted == ParameterType::byte_list) return as_bytes(*integers).value_or(value);
  }
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    if (wanted == ParameterType::integer_list) return as_integers(*numbers).value_or(value);
  }
  return value;
}

}  // namespace bw::foxglove
