// How lines of a plot are told apart: colours that people with any colour vision tell apart (after Okabe and Ito,
// and Tol), and dashes for paper without colour.
#pragma once

#include <string>
#include <string_view>

#include "components/evaluation/svg_writer.hpp"

namespace bw {

inline constexpr std::string_view kInk = "#1b2530";
inline constexpr std::string_view kGrey = "#767676";
inline constexpr std::string_view kBlue = "#0072b2";
inline constexpr std::string_view kVermilion = "#d55e00";
inline constexpr std::string_view kGreen = "#00795a";
inline constexpr std::string_view kPurple = "#aa3377";

struct PlotStyle {
  std::string_view color = kInk;
  std::string_view dash = {};  ///< as stroke-dasharray [px]; empty: a whole line
  double width = 1.8;          ///< [px]
  double opacity = 1.0;
};

/// The line number `index` of a plot; the colours come again after four, with dashes.
inline PlotStyle style_of(std::size_t index) {
  constexpr std::string_view kColors[] = {kBlue, kVermilion, kGreen, kPurple};
  constexpr std::string_view kDashes[] = {"", "7 3", "2 2.5", "9 3 2 3"};
  return {.color = kColors[index % 4], .dash = kDashes[(index % 4 + index / 4) % 4]};
}

/// Attributes of a line.
inline std::string stroke(const PlotStyle& style) {
  std::string text =
      "stroke=\"" + std::string(style.color) + "\" stroke-width=\"" + fixed(style.width, 1) + '"';
  if (!style.dash.empty()) text += " stroke-dasharray=\"" + std::string(style.dash) + '"';
  if (style.opacity < 1.0) text += " stroke-opacity=\"" + fixed(style.opacity, 2) + '"';
  return text;
}

/// Attributes of a text of `size` [px].
inline std::string text_style(int size, std::string_view anchor = "start", std::string_view color = kInk) {
  std::string text = "font-size=\"" + std::to_string(size) + "\" fill=\"" + std::string(color) + '"';
  if (anchor != "start") text += " text-anchor=\"" + std::string(anchor) + '"';
  return text;
}

}  // namespace bw
