// A drawing in the units of its subject: a window of a plane (metres, or velocities), with axes, arrows,
// discs and a key. The same bytes for the same input.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "components/evaluation/svg_writer.hpp"

namespace bw::figures {

// Colours that people with any colour vision tell apart (Okabe and Ito).
inline constexpr std::string_view kBlack = "#222222";
inline constexpr std::string_view kGrey = "#9a9a9a";
inline constexpr std::string_view kBlue = "#0072b2";
inline constexpr std::string_view kSky = "#56b4e9";
inline constexpr std::string_view kGreen = "#009e73";
inline constexpr std::string_view kOrange = "#e69f00";
inline constexpr std::string_view kVermilion = "#d55e00";
inline constexpr std::string_view kPurple = "#cc79a7";

struct Axes {
  std::string x;  ///< label with its unit
  std::string y;
  double tick = 1.0;      ///< between two numbers
  int decimals = 0;       ///< of these
  bool is_metric = true;  ///< one scale for both axes
};

/// Of a map or of odom.
inline const Axes kFloor{.x = "x [m]", .y = "y [m]"};

class Plane {
 public:
  /// `width` pixels wide in all. Of axes that are not metric the drawing is `height` pixels high.
  Plane(std::string title, const Eigen::AlignedBox2d& window, Axes axes, double width = 760.0,
        double height = 420.0);

  void curve(const std::vector<Vector2>& points, std::string_view color, double width = 2.0,
             std::string_view dash = "");
  void area(const std::vector<Vector2>& points, std::string_view color, double opacity);
  void arrow(const Vector2& from, const Vector2& by, std::string_view color, double width = 1.6);
  /// Outlined, and filled with `opacity`.
  void disc(const Vector2& center, double radius, std::string_view color, double opacity = 0.25);
  /// Where `covariance` reaches `sigmas` standard deviations.
  void ellipse(const Vector2& mean, const Eigen::Matrix2d& covariance, double sigmas, std::string_view color);
  /// Its radius is in pixels.
  void dot(const Vector2& center, double radius, std::string_view color, double opacity = 1.0);
  void cell(const Eigen::AlignedBox2d& cell, std::string_view color, double opacity);
  /// Cells of `size` over the whole window, each as dark as `shade` [0, 1] of its middle; what is below 0.03
  /// is left out.
  void shades(double size, std::string_view color, const std::function<double(const Vector2&)>& shade);
  /// `right` [px] from the position and `up` from it.
  void note(const Vector2& at, std::string_view text, double right = 6.0, double up = 6.0,
            std::string_view color = kBlack);
  /// A line of the key below the drawing.
  void key(std::string_view color, std::string_view text);

  std::string finish() &&;

 private:
  Vector2 pixel(const Vector2& p) const;
  std::string points_of(const std::vector<Vector2>& points) const;
  void draw_axes(SvgWriter& svg) const;

  std::string title_;
  Eigen::AlignedBox2d window_;
  Axes axes_;
  double width_, height_;  ///< of the drawing [px]
  Vector2 scale_;          ///< [px] for one unit
  std::string body_;
  std::vector<std::pair<std::string, std::string>> key_;  ///< colour, text
};

}  // namespace bw::figures
