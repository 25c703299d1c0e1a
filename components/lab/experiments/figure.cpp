#include "components/lab/experiments/figure.hpp"

#include <utility>

#include "components/evaluation/svg_writer.hpp"

namespace bw {
namespace {

std::string symbol_of(const LegendEntry& entry) {
  constexpr double kWidth = 26.0, kHeight = 12.0;
  const Vector2 middle(kWidth / 2.0, kHeight / 2.0);
  const std::string color(entry.style.color);
  SvgWriter svg(kWidth, kHeight);
  switch (entry.symbol) {
    case LegendSymbol::line:
      svg.line({1.0, middle.y()}, {kWidth - 1.0, middle.y()}, stroke(entry.style));
      break;
    case LegendSymbol::dots:
      for (const double x : {6.0, 13.0, 20.0}) svg.circle({x, middle.y()}, 2.0, "fill=\"" + color + '"');
      break;
    case LegendSymbol::body:
      svg.circle(middle, 5.0, "fill=\"" + color + "\" fill-opacity=\"0.15\" stroke=\"" + color + '"');
      break;
    case LegendSymbol::published:
      svg.polyline({middle + Vector2(0.0, -5.0), middle + Vector2(5.0, 0.0), middle + Vector2(0.0, 5.0),
                    middle + Vector2(-5.0, 0.0), middle + Vector2(0.0, -5.0)},
                   stroke({.width = 1.6}));
      break;
    case LegendSymbol::measured:
      svg.line({middle.x(), 0.0}, {middle.x(), kHeight}, stroke({.color = entry.style.color, .width = 1.6}));
      svg.circle(middle, 3.5, "fill=\"" + color + '"');
      break;
    case LegendSymbol::area:
      svg.rectangle({2.0, 0.0}, kWidth - 4.0, kHeight, "fill=\"" + color + '"');
      break;
  }
  return std::move(svg).finish();
}

}  // namespace

std::string to_html(const Figure& figure) {
  std::string html =
      "<figure><figcaption><b>" + xml_text(figure.title) + ".</b> " + figure.caption + "</figcaption>\n";
  if (!figure.legend.empty()) {
    html += "<div class=\"legend\">";
    for (const LegendEntry& entry : figure.legend)
      html += "<span>" + symbol_of(entry) + xml_text(entry.label) + "</span>\n";
    html += "</div>\n";
  }
  html += "<div class=\"pictures in" + std::to_string(figure.columns) + "\">\n";
  for (const std::string& picture : figure.pictures) html += picture;
  return html + "</div></figure>\n";
}

}  // namespace bw
