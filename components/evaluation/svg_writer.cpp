#include "components/evaluation/svg_writer.hpp"

#include <charconv>
#include <cmath>
#include <utility>

namespace bw {
namespace {

std::string px(double value) { return fixed(value, 1); }
std::string attribute(std::string_view name, double value) {
  return " " + std::string(name) + "=\"" + px(value) + '"';
}

}  // namespace

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  char buffer[400];
  const auto result =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
  std::string text(buffer, result.ptr);
  const bool is_negative_zero = text[0] == '-' && text.find_first_of("123456789") == std::string::npos;
  return is_negative_zero ? text.substr(1) : text;
}

std::string xml_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) safe += c;
    }
  }
  return safe;
}

SvgWriter::SvgWriter(double width, double height) {
  out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + px(width) + ' ' + px(height) + '"' +
         attribute("width", width) + attribute("height", height) +
         " font-family=\"'Inter','Segoe UI','Helvetica Neue',Arial,sans-serif\">\n";
}

void SvgWriter::rectangle(const Vector2& corner, double width, double height, std::string_view style) {
  out_ += "<rect" + attribute("x", corner.x()) + attribute("y", corner.y()) + attribute("width", width) +
          attribute("height", height) + ' ' + std::string(style) + "/>\n";
}

void SvgWriter::circle(const Vector2& center, double radius, std::string_view style) {
  out_ += "<circle" + attribute("cx", center.x()) + attribute("cy", center.y()) + attribute("r", radius) +
          ' ' + std::string(style) + "/>\n";
}

void SvgWriter::line(const Vector2& a, const Vector2& b, std::string_view style) {
  out_ += "<line" + attribute("x1", a.x()) + attribute("y1", a.y()) + attribute("x2", b.x()) +
          attribute("y2", b.y()) + ' ' + std::string(style) + "/>\n";
}

void SvgWriter::polyline(const std::vector<Vector2>& points, std::string_view style) {
  out_ += "<polyline points=\"";
  for (const Vector2& p : points) out_ += px(p.x()) + ',' + px(p.y()) + ' ';
  out_ += "\" fill=\"none\" " + std::string(style) + "/>\n";
}

void SvgWriter::path(std::string_view data, std::string_view style) {
  out_ += "<path d=\"" + std::string(data) + "\" " + std::string(style) + "/>\n";
}

void SvgWriter::text(const Vector2& position, std::string_view content, std::string_view style) {
  out_ += "<text" + attribute("x", position.x()) + attribute("y", position.y()) + ' ' + std::string(style) +
          '>' + xml_text(content) + "</text>\n";
}

std::string SvgWriter::finish() && {
  out_ += "</svg>\n";
  return std::move(out_);
}

}  // namespace bw
