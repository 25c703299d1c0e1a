// How the parts of a picture are told apart. Which shade a colour has, in the light and in the dark, is the
// page's matter.
#pragma once

#include <cstddef>
#include <cstdint>

#include <nlohmann/json.hpp>

namespace bw::report {

enum class Color : std::uint8_t { ink, grey, blue, vermilion, green, purple, sky, ochre, violet, red };

NLOHMANN_JSON_SERIALIZE_ENUM(Color, {{Color::ink, "ink"},
                                     {Color::grey, "grey"},
                                     {Color::blue, "blue"},
                                     {Color::vermilion, "vermilion"},
                                     {Color::green, "green"},
                                     {Color::purple, "purple"},
                                     {Color::sky, "sky"},
                                     {Color::ochre, "ochre"},
                                     {Color::violet, "violet"},
                                     {Color::red, "red"}})

/// Dashes tell lines apart on paper without colour.
enum class Dash : std::uint8_t { none, dashes, dots, both };

NLOHMANN_JSON_SERIALIZE_ENUM(
    Dash, {{Dash::none, "none"}, {Dash::dashes, "dashes"}, {Dash::dots, "dots"}, {Dash::both, "both"}})

struct Look {
  Color color = Color::ink;
  Dash dash = Dash::none;
  double width = 1.8;  ///< [px]
  double opacity = 1.0;
};

/// The line number `index` of a picture; the colours come again after four, with other dashes.
inline Look look_of(std::size_t index) {
  constexpr Color kColors[] = {Color::blue, Color::vermilion, Color::green, Color::purple};
  return {.color = kColors[index % 4], .dash = static_cast<Dash>((index % 4 + index / 4) % 4)};
}

}  // namespace bw::report
