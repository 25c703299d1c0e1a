#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

#include "components/files/map_file.hpp"

namespace bw {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  throw std::runtime_error(path.string() + ": cannot be " + what + ": " + std::strerror(errno));
}

// A reader, or a power cut, meets the old file or the new one, never a part.
void write_whole(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path part = path;
  part += ".part";
  const int file = open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) fail(part, "opened");
  bool ok = true;
  while (ok && !bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    ok = written >= 0 || errno == EINTR;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  ok = ok && fsync(file) == 0;
  const int error = errno;
  ok = close(file) == 0 && ok;
  if (!ok || rename(part.c_str(), path.c_str()) != 0) {
    if (!ok) errno = error;
    const int reason = errno;
    unlink(part.c_str());
    errno = reason;
    fail(path, "written");
  }
}

// Shades by map_server's custom: 205 lies between the thresholds 0.196 and 0.65.
char trinary_pixel(std::int8_t cell) {
  if (cell == OccupancyGrid::kFree) return static_cast<char>(254);
  return cell == OccupancyGrid::kOccupied ? '\0' : static_cast<char>(205);
}

char raw_pixel(std::int8_t cell) { return cell < 0 ? static_cast<char>(255) : static_cast<char>(cell); }

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

}  // namespace

void save_map(const OccupancyGrid& grid, const std::filesystem::path& yaml) {
  std::filesystem::path image = yaml;
  image.replace_extension(".pgm");
  const bool trinary = std::all_of(grid.cells.begin(), grid.cells.end(), [](std::int8_t cell) {
    return cell < 0 || cell == OccupancyGrid::kFree || cell == OccupancyGrid::kOccupied;
  });
  std::string pixels = "P5\n" + std::to_string(grid.width) + " " + std::to_string(grid.height) + "\n255\n";
  pixels.reserve(pixels.size() + grid.cells.size());
  for (int row = grid.height; row-- > 0;) {
    for (int column = 0; column < grid.width; ++column) {
      const std::int8_t cell = grid.at(column, row);
      pixels.push_back(trinary ? trinary_pixel(cell) : raw_pixel(cell));
    }
  }
  write_whole(image, pixels);
  write_whole(yaml, "image: " + image.filename().string() + "\nmode: " + (trinary ? "trinary" : "raw") +
                        "\nresolution: " + number(grid.resolution) + "\norigin: [" + number(grid.origin.x()) +
                        ", " + number(grid.origin.y()) +
                        ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

}  // namespace bw
