#include "components/lab/figures/plane.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

namespace bw::figures {
namespace {

constexpr double kLeft = 56.0, kTop = 40.0, kRight = 16.0, kBelow = 46.0;  // [px] around the drawing
constexpr double kKeyLine = 20.0;                                          // [px]

std::string px(double value) { return fixed(value, 1); }

std::string stroke(std::string_view color, double width) {
  return "stroke=\"" + std::string(color) + "\" stroke-width=\"" + px(width) + "\"";
}

}  // namespace

Plane::Plane(std::string title, const Eigen::AlignedBox2d& window, Axes axes, double width, double height)
    : title_(std::move(title)),
      window_(window),
      axes_(std::move(axes)),
      width_(width - kLeft - kRight),
      height_(height) {
  const Vector2 size = window_.sizes();
  if (axes_.is_metric) height_ = width_ * size.y() / size.x();
  scale_ = {width_ / size.x(), height_ / size.y()};
}

Vector2 Plane::pixel(const Vector2& p) const {
  return {kLeft + (p.x() - window_.min().x()) * scale_.x(), kTop + (window_.max().y() - p.y()) * scale_.y()};
}

std::string Plane::points_of(const std::vector<Vector2>& points) const {
  std::string text;
  for (const Vector2& point : points) {
    const Vector2 p = pixel(point);
    text += px(p.x()) + ',' + px(p.y()) + ' ';
  }
  return text;
}

void Plane::curve(const std::vector<Vector2>& points, std::string_view color, double width,
                  std::string_view dash) {
  body_ += "<polyline points=\"" + points_of(points) + "\" fill=\"none\" " + stroke(color, width) +
           (dash.empty() ? "" : " stroke-dasharray=\"" + std::string(dash) + '"') + "/>\n";
}

void Plane::area(const std::vector<Vector2>& points, std::string_view color, double opacity) {
  body_ += "<polygon points=\"" + points_of(points) + "\" fill=\"" + std::string(color) +
           "\" fill-opacity=\"" + fixed(opacity, 2) + "\" " + stroke(color, 1.0) + "/>\n";
}

void Plane::arrow(const Vector2& from, const Vector2& by, std::string_view color, double width) {
  const Vector2 a = pixel(from), b = pixel(from + by);
  const double length = (b - a).norm();
  if (!(length > 1.0)) return;
  const Vector2 along = (b - a) / length, across(-along.y(), along.x());
  const double head = std::min(8.0, 0.6 * length);
  const Vector2 left = b - head * along + 0.4 * head * across, right = b - head * along - 0.4 * head * across;
  body_ += "<path d=\"M" + px(a.x()) + ' ' + px(a.y()) + " L" + px(b.x()) + ' ' + px(b.y()) + " M" +
           px(left.x()) + ' ' + px(left.y()) + " L" + px(b.x()) + ' ' + px(b.y()) + " L" + px(right.x()) +
           ' ' + px(right.y()) + "\" fill=\"none\" " + stroke(color, width) + "/>\n";
}

void Plane::disc(const Vector2& center, double radius, std::string_view color, double opacity) {
  const Vector2 p = pixel(center);
  body_ += "<ellipse cx=\"" + px(p.x()) + "\" cy=\"" + px(p.y()) + "\" rx=\"" + px(radius * scale_.x()) +
           "\" ry=\"" + px(radius * scale_.y()) + "\" fill=\"" + std::string(color) + "\" fill-opacity=\"" +
           fixed(opacity, 2) + "\" " + stroke(color, 1.2) + "/>\n";
}

void Plane::ellipse(const Vector2& mean, const Eigen::Matrix2d& covariance, double sigmas,
                    std::string_view color) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance);
  const Eigen::Matrix2d half =
      axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  std::vector<Vector2> rim;
  for (int i = 0; i <= 48; ++i) {
    const double angle = 2.0 * M_PI * i / 48.0;
    rim.push_back(mean + sigmas * (half * Vector2(std::cos(angle), std::sin(angle))));
  }
  area(rim, color, 0.15);
}

void Plane::dot(const Vector2& center, double radius, std::string_view color, double opacity) {
  const Vector2 p = pixel(center);
  body_ += "<circle cx=\"" + px(p.x()) + "\" cy=\"" + px(p.y()) + "\" r=\"" + px(radius) + "\" fill=\"" +
           std::string(color) + "\" fill-opacity=\"" + fixed(opacity, 2) + "\"/>\n";
}

void Plane::cell(const Eigen::AlignedBox2d& cell, std::string_view color, double opacity) {
  const Vector2 corner = pixel({cell.min().x(), cell.max().y()});
  body_ += "<rect x=\"" + px(corner.x()) + "\" y=\"" + px(corner.y()) + "\" width=\"" +
           px(cell.sizes().x() * scale_.x()) + "\" height=\"" + px(cell.sizes().y() * scale_.y()) +
           "\" fill=\"" + std::string(color) + "\" fill-opacity=\"" + fixed(opacity, 2) + "\"/>\n";
}

void Plane::shades(double size, std::string_view color, const std::function<double(const Vector2&)>& shade) {
  constexpr int kLevels = 12;  // neighbours of one level in a row are one rectangle
  const auto count = [size](double length) { return static_cast<int>(std::lround(length / size)); };
  const int columns = count(window_.sizes().x()), rows = count(window_.sizes().y());
  for (int row = 0; row < rows; ++row) {
    const auto level_at = [&](int column) {
      return static_cast<int>(
          std::lround(kLevels * shade(window_.min() + size * Vector2(column + 0.5, row + 0.5))));
    };
    for (int first = 0, last = 0; first < columns; first = last) {
      const int level = level_at(first);
      for (last = first + 1; last < columns && level_at(last) == level;) ++last;
      if (level == 0) continue;
      cell({window_.min() + size * Vector2(first, row), window_.min() + size * Vector2(last, row + 1)}, color,
           static_cast<double>(level) / kLevels);
    }
  }
}

void Plane::note(const Vector2& at, std::string_view text, double right, double up, std::string_view color) {
  const Vector2 p = pixel(at);
  body_ += "<text x=\"" + px(p.x() + right) + "\" y=\"" + px(p.y() - up) + "\" font-size=\"12\" fill=\"" +
           std::string(color) + "\">" + xml_text(text) + "</text>\n";
}

void Plane::key(std::string_view color, std::string_view text) { key_.emplace_back(color, text); }

void Plane::draw_axes(SvgWriter& svg) const {
  constexpr std::string_view kSmall = "font-size=\"11\" fill=\"#555555\" text-anchor=\"middle\"";
  const auto first = [this](double low) { return std::ceil(low / axes_.tick - 1e-9) * axes_.tick; };
  for (double x = first(window_.min().x()); x <= window_.max().x() + 1e-9; x += axes_.tick) {
    const Vector2 p = pixel({x, window_.min().y()});
    svg.line(p, p - Vector2(0.0, height_), "stroke=\"#eeeeee\"");
    svg.text(p + Vector2(0.0, 15.0), fixed(x, axes_.decimals), kSmall);
  }
  for (double y = first(window_.min().y()); y <= window_.max().y() + 1e-9; y += axes_.tick) {
    const Vector2 p = pixel({window_.min().x(), y});
    svg.line(p, p + Vector2(width_, 0.0), "stroke=\"#eeeeee\"");
    svg.text(p + Vector2(-8.0, 4.0), fixed(y, axes_.decimals),
             "font-size=\"11\" fill=\"#555555\" text-anchor=\"end\"");
  }
  svg.text({kLeft + 0.5 * width_, kTop + height_ + 34.0}, axes_.x, kSmall);
  svg.open("<g transform=\"rotate(-90 14 " + px(kTop + 0.5 * height_) + ")\">");
  svg.text({14.0, kTop + 0.5 * height_}, axes_.y, kSmall);
  svg.close("</g>");
}

std::string Plane::finish() && {
  const double width = kLeft + width_ + kRight;
  const double height = kTop + height_ + kBelow + kKeyLine * static_cast<double>(key_.size()) + 6.0;
  SvgWriter svg(width, height);
  svg.rectangle({0.0, 0.0}, width, height, "fill=\"#ffffff\"");
  svg.text({kLeft, 24.0}, title_, "font-size=\"15\" font-weight=\"600\" fill=\"#222222\"");
  draw_axes(svg);
  svg.open("<clipPath id=\"window\"><rect x=\"" + px(kLeft) + "\" y=\"" + px(kTop) + "\" width=\"" +
           px(width_) + "\" height=\"" + px(height_) + "\"/></clipPath>");
  svg.open("<g clip-path=\"url(#window)\">");
  svg.open(body_);
  svg.close("</g>");
  svg.rectangle({kLeft, kTop}, width_, height_, "fill=\"none\" stroke=\"#bbbbbb\"");
  double y = kTop + height_ + kBelow + 8.0;
  for (const auto& [color, text] : key_) {
    svg.line({kLeft, y - 4.0}, {kLeft + 22.0, y - 4.0}, stroke(color, 4.0));
    svg.text({kLeft + 30.0, y}, text, "font-size=\"12\" fill=\"#222222\"");
    y += kKeyLine;
  }
  return std::move(svg).finish();
}

}  // namespace bw::figures
