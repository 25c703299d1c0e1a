#include "components/lab/tune/tuned_parameters.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "components/lab/bench/planner_overrides.hpp"
#include "components/model/random.hpp"
#include "runtime/parameters/list_parameters.hpp"

namespace bw::tune {
namespace {

bool drives_bands(const std::string& planner) {
  return planner == "teb" || planner == "pteb" || planner == "eteb" || planner == "teb_homotopy";
}

bool is_of(const std::string& name, const std::string& planner) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) return true;
  const std::string section = name.substr(0, dot);
  return section == planner || (section == "teb" && drives_bands(planner));
}

}  // namespace

std::vector<TunedParameter> parameters_of(const std::string& planner, const std::vector<std::string>& names,
                                          const std::vector<std::string>& set) {
  PlannerOptions options;
  apply_overrides(options, set);
  std::vector<TunedParameter> tuned;
  std::vector<std::string> left = names;
  for (const ParameterRow& row : list_parameters(options)) {
    const bool is_number = row.type == "double" || row.type == "integer";
    if (names.empty() ? !is_of(row.name, planner) : std::ranges::find(names, row.name) == names.end())
      continue;
    std::erase(left, row.name);
    if (!is_number) {
      if (names.empty()) continue;
      throw std::runtime_error(row.name + ": is no number");
    }
    double value = 0.0;
    std::from_chars(row.value.data(), row.value.data() + row.value.size(), value);
    tuned.push_back({row.name, value, row.min, row.max, row.type == "integer"});
  }
  if (!left.empty()) throw std::runtime_error(left.front() + ": is no parameter of a planner");
  if (tuned.empty()) throw std::runtime_error(planner + ": has no number of its own; name some");
  return tuned;
}

std::vector<std::string> settings_of(const std::vector<TunedParameter>& parameters, std::size_t number,
                                     std::uint64_t seed, double widest) {
  std::vector<std::string> settings;
  if (number == 0) return settings;
  Random random(1'000'003 * seed + number);
  for (const TunedParameter& parameter : parameters) {
    const bool is_turned = random.uniform() < 0.5;
    const double factor = std::exp(std::log(widest) * random.uniform(-1.0, 1.0));
    if (!is_turned) continue;
    double value = std::clamp(parameter.value * factor, parameter.min, parameter.max);
    if (parameter.integer) value = std::round(value);
    if (value == parameter.value) continue;
    settings.push_back(parameter.integer ? fmt::format("{}={:.0f}", parameter.name, value)
                                         : fmt::format("{}={:.6g}", parameter.name, value));
  }
  return settings;
}

}  // namespace bw::tune
