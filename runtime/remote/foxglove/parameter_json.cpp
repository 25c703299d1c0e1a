#include "runtime/remote/foxglove/parameter_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <nlohmann/json.hpp>

#include "runtime/remote/foxglove/base64.hpp"

namespace bw::foxglove {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using Read = std::variant<ParameterValue, BrokenRule>;

ordered_json number_json(double value) {
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return "nan";
  return value > 0 ? "inf" : "-inf";
}

/// What stands beside the name.
struct Writer {
  ordered_json& parameter;

  void operator()(std::monostate) const {}
  void operator()(double value) const {
    parameter["value"] = number_json(value);
    if (std::isfinite(value)) parameter["type"] = "float64";
  }
  void operator()(const std::vector<std::uint8_t>& bytes) const {
    parameter["value"] = to_base64(bytes);
    parameter["type"] = "byte_array";
  }
  void operator()(const std::vector<double>& values) const {
    ordered_json list = ordered_json::array();
    for (const double value : values) list.push_back(number_json(value));
    parameter["value"] = std::move(list);
    if (std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
      parameter["type"] = "float64_array";
  }
  void operator()(const auto& value) const { parameter["value"] = value; }
};

bool is_integer(const json& value) {
  return value.is_number_integer() &&
         (!value.is_number_unsigned() ||
          value.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()));
}

template <class Element>
Read list_of(const json& values) {
  return ParameterValue{values.get<std::vector<Element>>()};
}

Read read_list(const json& values, bool is_floating) {
  const auto all = [&values](auto is) { return std::all_of(values.begin(), values.end(), is); };
  const bool is_all_numbers = all([](const json& v) { return v.is_number(); });
  if (is_floating && !is_all_numbers)
    return BrokenRule{"must be an array of numbers, as its type float64_array says"};
  if (is_floating) return list_of<double>(values);
  if (all([](const json& v) { return v.is_string(); })) return list_of<std::string>(values);
  if (all([](const json& v) { return v.is_boolean(); })) return list_of<bool>(values);
  if (all(is_integer)) return list_of<std::int64_t>(values);
  if (is_all_numbers) return list_of<double>(values);
  return BrokenRule{"must be an array of one kind: numbers, booleans or strings"};
}

Read read_bytes(const json& value) {
  if (value.is_string()) {
    if (auto bytes = from_base64(value.get_ref<const std::string&>()))
      return ParameterValue{std::move(*bytes)};
  }
  return BrokenRule{"must be a string in base64, as its type byte_array says"};
}

}  // namespace

ordered_json parameter_json(const NamedValue& parameter) {
  ordered_json written = {{"name", parameter.name}};
  std::visit(Writer{written}, parameter.value);
  return written;
}

Read parameter_value_of(const json& value, const std::optional<std::string>& type) {
  const bool is_list = type == "float64_array";
  if (type == "byte_array") return read_bytes(value);
  if (type && type != "float64" && !is_list)
    return BrokenRule{"has a type that is none of byte_array, float64, float64_array"};
  if (value.is_array() && (is_list || !type)) return read_list(value, is_list);
  if (is_list) return BrokenRule{"must be an array of numbers, as its type float64_array says"};
  if (type && !value.is_number()) return BrokenRule{"must be a number, as its type float64 says"};
  if (value.is_boolean()) return ParameterValue{value.get<bool>()};
  if (value.is_string()) return ParameterValue{value.get<std::string>()};
  if (is_integer(value) && !type) return ParameterValue{value.get<std::int64_t>()};
  if (value.is_number()) return ParameterValue{value.get<double>()};
  return BrokenRule{"must be a number, boolean, string or an array of these"};
}

}  // namespace bw::foxglove
