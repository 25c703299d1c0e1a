// The few SVG elements the picture is made of, as text. Coordinates in pixels, y downwards. The same on every
// system and locale.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

/// Fixed notation; what is not finite becomes a dash.
std::string fixed(double value, int decimals);
/// Text with & < > " made safe for XML, control characters dropped.
std::string xml_text(std::string_view text);

class SvgWriter {
 public:
  SvgWriter(double width, double height);

  /// `style` is a list of attributes, such as fill="#fff".
  void rectangle(const Vector2& corner, double width, double height, std::string_view style);
  void circle(const Vector2& center, double radius, std::string_view style);
  void line(const Vector2& a, const Vector2& b, std::string_view style);
  void polyline(const std::vector<Vector2>& points, std::string_view style);
  void path(std::string_view data, std::string_view style);
  void text(const Vector2& position, std::string_view content, std::string_view style);
  /// Everything until close() goes through this opening tag, such as <g clip-path="url(#view)">.
  void open(std::string_view tag) { out_ += std::string(tag) + "\n"; }
  void close(std::string_view tag) { open(tag); }

  std::string finish() &&;

 private:
  std::string out_;
};

}  // namespace bw
