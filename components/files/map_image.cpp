#include "components/files/map_image.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <png.h>

#include "components/model/occupancy_grid.hpp"
#include "runtime/parameters/config_error.hpp"

namespace bw {
namespace {

[[noreturn]] void refuse(const std::string& file, int line, std::string key, std::string value,
                         std::string rule) {
  throw ConfigError(Violation{{file, line}, std::move(key), std::move(value), std::move(rule)});
}

std::string read_bytes(const std::filesystem::path& path) {
  const std::string file = path.string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    refuse(file, 0, "", "", "must be a file that can be read");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) refuse(file, 0, "", "", "must be a file that can be read");
  if (size > kMaxImageBytes) {
    refuse(file, 0, "", "", "must have at most " + std::to_string(kMaxImageBytes >> 20) + " MiB");
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    refuse(file, 0, "", "", "must be a file that can be read");
  }
  return bytes;
}

void check_size(const std::string& file, std::uint64_t width, std::uint64_t height) {
  if (width == 0) refuse(file, 0, "width", "0", "must be at least 1");
  if (height == 0) refuse(file, 0, "height", "0", "must be at least 1");
  if (width > kMaxMapCells || height > kMaxMapCells || width * height > kMaxMapCells) {
    refuse(file, 0, "width x height", std::to_string(width) + " x " + std::to_string(height),
           "must be at most " + std::to_string(kMaxMapCells) + " cells");
  }
}

std::size_t flipped_index(const MapImage& image, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(image.width);
  return (static_cast<std::size_t>(image.height) - 1 - pixel / width) * width + pixel % width;
}

// Tokens of a PNM header or a P2 raster: numbers between white space, '#' starts a comment that ends with its
// line.
class PgmReader {
 public:
  PgmReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  MapImage read(const CellOfShade& cell_of_shade) {
    const bool plain = bytes_[1] == '2';
    at_ = 2;
    const std::uint32_t width = number("width");
    const std::uint32_t height = number("height");
    check_size(file_, width, height);
    const std::uint32_t max = number("maxval");
    if (max < 1 || max > 65535)
      refuse(file_, line_, "maxval", std::to_string(max), "must be from 1 to 65535");
    if (!plain) ++at_;  // exactly one white space ends the header
    const std::size_t count = std::size_t{width} * height;
    const std::size_t bytes_per_pixel = max > 255 ? 2 : 1;
    // A plain pixel takes a digit and a space, the last one a digit.
    const std::size_t needed = plain ? 2 * count - 1 : bytes_per_pixel * count;
    const std::size_t left = bytes_.size() - std::min(at_, bytes_.size());
    if (left < needed) {
      refuse(file_, 0, "pixels", std::to_string(left) + " bytes",
             "must have at least " + std::to_string(needed) +
                 " bytes for its width and height (is it cut short?)");
    }
    std::vector<std::int8_t> cell_of_value(max + 1);
    for (std::uint32_t v = 0; v <= max; ++v) cell_of_value[v] = cell_of_shade(static_cast<double>(v) / max);

    MapImage image{static_cast<int>(width), static_cast<int>(height), std::vector<std::int8_t>(count)};
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t value = plain ? number("pixel") : binary_value(bytes_per_pixel);
      if (value > max) {
        refuse(file_, plain ? line_ : 0, "pixel " + std::to_string(i), std::to_string(value),
               "must be at most maxval (" + std::to_string(max) + ")");
      }
      image.cells[flipped_index(image, i)] = cell_of_value[value];
    }
    return image;
  }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  std::uint32_t number(const char* key) {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#') at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      if (at_ < bytes_.size() && bytes_[at_] == '\n') ++line_;
      ++at_;
    }
    const std::size_t first = at_;
    std::uint32_t value = 0;
    for (; at_ < bytes_.size() && is_digit(bytes_[at_]) && at_ - first < 9; ++at_) {
      value = value * 10 + static_cast<std::uint32_t>(bytes_[at_] - '0');
    }
    const bool ended = at_ >= bytes_.size() || is_space(bytes_[at_]) || bytes_[at_] == '#';
    if (at_ == first || !ended) refuse(file_, line_, key, "", "must be a number of at most 9 digits");
    return value;
  }

  std::uint32_t binary_value(std::size_t bytes_per_pixel) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < bytes_per_pixel; ++k)
      value = value << 8 | static_cast<std::uint8_t>(bytes_[at_++]);
    return value;
  }

  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

// Width and height as the header claims them, refused unless the file is long enough to hold that many
// pixels.
void check_png_header(std::string_view bytes, const std::string& file) {
  constexpr std::size_t kHeaderEnd = 33;
  if (bytes.size() < kHeaderEnd || bytes.substr(12, 4) != "IHDR")
    refuse(file, 0, "", "", "must be a whole PNG");
  const auto byte = [&](std::size_t i) { return std::uint64_t{static_cast<std::uint8_t>(bytes[i])}; };
  const auto word = [&](std::size_t i) {
    return byte(i) << 24 | byte(i + 1) << 16 | byte(i + 2) << 8 | byte(i + 3);
  };
  const std::uint64_t width = word(16);
  const std::uint64_t height = word(20);
  check_size(file, width, height);
  constexpr std::array<std::uint64_t, 7> kChannels{1, 0, 3, 1, 2, 0, 4};  // by colour type
  const std::uint64_t channels = byte(25) < kChannels.size() ? kChannels[byte(25)] : 0;
  constexpr std::uint64_t kBestDeflateRatio = 1032;
  const std::uint64_t pixel_bytes = height * ((width * channels * byte(24) + 7) / 8);
  if (pixel_bytes > kBestDeflateRatio * bytes.size()) {
    refuse(file, 0, "width x height", std::to_string(width) + " x " + std::to_string(height),
           "must fit the file's length (is it cut short?)");
  }
}

MapImage read_png(std::string_view bytes, const std::string& file, const CellOfShade& cell_of_shade) {
  check_png_header(bytes, file);
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  const auto check = [&](int ok) {
    if (ok != 0) return;
    const std::string message = png.message;
    png_image_free(&png);
    refuse(file, 0, "", "", "must be a whole PNG (" + message + ")");
  };
  check(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()));
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16-bit maps are scaled, not re-lit
  const bool gray = (png.format & (PNG_FORMAT_FLAG_ALPHA | PNG_FORMAT_FLAG_COLOR)) == 0;
  png.format = gray ? PNG_FORMAT_GRAY : PNG_FORMAT_RGBA;
  const std::size_t channels = gray ? 1 : 4;
  const std::size_t count = std::size_t{png.width} * png.height;
  if (count > kMaxMapCells || count * channels > kMaxImageBytes) {
    png_image_free(&png);
    refuse(file, 0, "width x height", std::to_string(count) + " coloured pixels",
           "must be at most " + std::to_string(kMaxImageBytes / 4) + " (save it as gray)");
  }
  std::vector<std::uint8_t> pixels(count * channels);
  check(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr));

  const unsigned full = gray ? 255 : 3 * 255;
  std::vector<std::int8_t> cell_of_sum(full + 1);
  for (unsigned sum = 0; sum <= full; ++sum)
    cell_of_sum[sum] = cell_of_shade(static_cast<double>(sum) / full);
  MapImage image{static_cast<int>(png.width), static_cast<int>(png.height), std::vector<std::int8_t>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* p = pixels.data() + i * channels;
    const bool transparent = !gray && p[3] != 255;
    const unsigned sum = gray ? p[0] : unsigned{p[0]} + p[1] + p[2];
    image.cells[flipped_index(image, i)] = transparent ? OccupancyGrid::kUnknown : cell_of_sum[sum];
  }
  return image;
}

}  // namespace

MapImage read_map_image(const std::filesystem::path& path, const CellOfShade& cell_of_shade) {
  const std::string file = path.string();
  const std::string bytes = read_bytes(path);
  const std::string_view view = bytes;
  if (view.substr(0, 2) == "P5" || view.substr(0, 2) == "P2")
    return PgmReader(view, file).read(cell_of_shade);
  if (view.substr(0, kPngSignature.size()) == kPngSignature) return read_png(view, file, cell_of_shade);
  refuse(file, 0, "", "", "must be a PGM (P2 or P5) or a PNG");
}

}  // namespace bw
