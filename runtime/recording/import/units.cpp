#include "runtime/recording/import/units.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace bw::imports {
namespace {

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

constexpr NamedUnit kUnits[] = {
    {"m", {1.0, {1, 0, 0}}},
    {"km", {1e3, {1, 0, 0}}},
    {"cm", {1e-2, {1, 0, 0}}},
    {"mm", {1e-3, {1, 0, 0}}},
    {"um", {1e-6, {1, 0, 0}}},
    {"in", {0.0254, {1, 0, 0}}},
    {"ft", {0.3048, {1, 0, 0}}},
    {"rad", {1.0, {0, 1, 0}}},
    {"mrad", {1e-3, {0, 1, 0}}},
    {"deg", {std::numbers::pi / 180.0, {0, 1, 0}}},
    {"rev", {2.0 * std::numbers::pi, {0, 1, 0}}},
    {"s", {1.0, {0, 0, 1}}},
    {"ms", {1e-3, {0, 0, 1}}},
    {"us", {1e-6, {0, 0, 1}}},
    {"ns", {1e-9, {0, 0, 1}}},
    {"min", {60.0, {0, 0, 1}}},
    {"h", {3600.0, {0, 0, 1}}},
    {"Hz", {1.0, {0, 0, -1}}},
    {"kn", {1852.0 / 3600.0, {1, 0, -1}}},
    {"rpm", {std::numbers::pi / 30.0, {0, 1, -1}}},
    {"g", {9.80665, {1, 0, -2}}},
};

/// A name, or a name with ^2.
std::optional<Unit> power_of(std::string_view text) {
  const bool squared = text.ends_with("^2");
  if (squared) text.remove_suffix(2);
  const auto* found =
      std::find_if(std::begin(kUnits), std::end(kUnits), [&](const NamedUnit& u) { return u.name == text; });
  if (found == std::end(kUnits)) return std::nullopt;
  Unit unit = found->unit;
  if (squared) {
    unit.scale *= unit.scale;
    for (int& power : unit.powers) power *= 2;
  }
  return unit;
}

}  // namespace

std::optional<Unit> unit_of(std::string_view text) {
  const std::size_t slash = text.find('/');
  std::optional<Unit> unit = power_of(text.substr(0, slash));
  if (!unit || slash == std::string_view::npos) return unit;
  const std::optional<Unit> below = power_of(text.substr(slash + 1));
  if (!below) return std::nullopt;
  unit->scale /= below->scale;
  for (std::size_t i = 0; i < unit->powers.size(); ++i) unit->powers[i] -= below->powers[i];
  return unit;
}

std::string_view known_units() {
  return "m, km, cm, mm, um, in, ft, rad, mrad, deg, rev, s, ms, us, ns, min, h, Hz, kn, rpm, g, "
         "any of them with ^2, and one over another (km/h, m/s^2)";
}

}  // namespace bw::imports
