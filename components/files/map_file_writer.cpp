#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <png.h>

#include "components/files/map_file.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {
namespace {

constexpr std::size_t kGrayAndAlpha = 2;  // bytes of a pixel

/// Gray and opacity of each cell, the top row first.
std::string pixels_of(const OccupancyGrid& grid, const MapShades& shades) {
  std::string pixels;
  pixels.reserve(grid.cells.size() * kGrayAndAlpha);
  for (int row = grid.height; row-- > 0;) {
    for (int column = 0; column < grid.width; ++column) {
      const std::optional<std::uint8_t> pixel = pixel_of_cell(shades, grid.at(column, row));
      constexpr std::uint8_t kGray = 128;
      constexpr std::uint8_t kOpaque = 255;
      pixels.push_back(static_cast<char>(pixel.value_or(kGray)));
      pixels.push_back(static_cast<char>(pixel ? kOpaque : 0));
    }
  }
  return pixels;
}

std::string pgm_of(const OccupancyGrid& grid, const std::string& pixels) {
  std::string file = "P5\n" + std::to_string(grid.width) + " " + std::to_string(grid.height) + "\n255\n";
  file.reserve(file.size() + grid.cells.size());
  for (std::size_t i = 0; i < pixels.size(); i += kGrayAndAlpha) {
    if (pixels[i + 1] == 0)
      throw std::runtime_error(
          "a PGM has no transparent pixels, which mode scale needs for unknown cells: save a png");
    file.push_back(pixels[i]);
  }
  return file;
}

std::string png_of(const OccupancyGrid& grid, const std::string& pixels) {
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(grid.width);
  png.height = static_cast<png_uint_32>(grid.height);
  png.format = PNG_FORMAT_GA;
  std::string file(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = file.size();
  if (png_image_write_to_memory(&png, file.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("no PNG could be made: ") + png.message);
  file.resize(size);
  return file;
}

/// The shortest text that reads back to the same number.
std::string number(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

std::string yaml_of(const OccupancyGrid& grid, const MapShades& shades, const std::string& image) {
  return "image: " + quoted(image) + "\nmode: " + std::string(text_of(shades.mode)) +
         "\nresolution: " + number(grid.resolution) + "\norigin: [" + number(grid.origin.x()) + ", " +
         number(grid.origin.y()) + ", 0]\nnegate: 0\noccupied_thresh: " + number(shades.occupied_thresh) +
         "\nfree_thresh: " + number(shades.free_thresh) + "\n";
}

}  // namespace

std::filesystem::path path_of_map(const std::filesystem::path& folder, const std::filesystem::path& asked) {
  namespace fs = std::filesystem;
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error("'" + asked.string() + "': maps are saved below " + folder.string() + ": " +
                             why);
  };
  if (!asked.has_filename() || asked.filename() == ".") refuse("it names no file");
  if (std::ranges::find(asked, fs::path("..")) != asked.end()) refuse("a path has no ..");
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) refuse(error.message());
  const fs::path parent = fs::canonical((root / asked).parent_path(), error);  // an absolute one stays itself
  if (error) refuse("there is no folder " + (root / asked).parent_path().string());
  const auto [differs, rest] = std::mismatch(root.begin(), root.end(), parent.begin(), parent.end());
  if (differs != root.end()) refuse(parent.string() + " is elsewhere");
  fs::path yaml = parent / asked.filename();
  if (yaml.extension() != ".yaml") yaml += ".yaml";
  return yaml;
}

void save_map(const OccupancyGrid& grid, const std::filesystem::path& yaml, const MapShades& shades,
              ImageFormat format, Existing existing) {
  if (const auto fault = fault_of(shades)) throw std::runtime_error(yaml.string() + ": " + *fault);
  // A mistyped folder is told and not made.
  const std::filesystem::path folder = yaml.has_parent_path() ? yaml.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error("cannot write " + yaml.string() + ": there is no folder " + folder.string());
  std::filesystem::path image = yaml;
  image.replace_extension("." + std::string(text_of(format)));
  for (const std::filesystem::path& file : {image, yaml}) {
    if (existing == Existing::refuse && std::filesystem::exists(std::filesystem::symlink_status(file)))
      throw std::runtime_error(file.string() + " exists already, and is not to be overwritten");
  }
  const std::string pixels = pixels_of(grid, shades);
  write_file_atomically(image, format == ImageFormat::png ? png_of(grid, pixels) : pgm_of(grid, pixels));
  write_file_atomically(yaml, yaml_of(grid, shades, image.filename().string()));
}

}  // namespace bw
